#include "host/fit/link_need.hpp"

#include "core/scene/kfb_limits.hpp"
#include "firmware/link/input_message.hpp"
#include "host/text/counted.hpp"

namespace kfast::fit {
namespace {

LinkUpdate update_of_text(const InputView& input)
{
    static_assert(kfb::max_text <= link::Text::max, "any text is one report");
    return {std::string{input.name} + ", a text", 1};
}

/// The pen is lifted between strokes.
LinkUpdate update_of_drawing(const InputView& input)
{
    const auto& [strokes, points, default_value] = input.drawing;
    return {std::string{input.name} + ", " + counted(points, "point") + " in " + counted(strokes, "stroke"),
            link::reports_of_drawing(points + strokes - 1)};
}

}

std::vector<LinkUpdate> link_need(const SceneView& scene)
{
    std::size_t numbers = 0;
    std::vector<LinkUpdate> others;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const InputView input = inputs.next();
        if (input.type == InputType::drawing)
            others.push_back(update_of_drawing(input));
        else if (input.type == InputType::text)
            others.push_back(update_of_text(input));
        else
            ++numbers;
    }
    std::vector<LinkUpdate> all;
    if (numbers != 0)
        all.push_back({counted(numbers, "number"), (numbers + link::Inputs::max - 1) / link::Inputs::max});
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

}
