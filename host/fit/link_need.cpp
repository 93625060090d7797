#include "host/fit/link_need.hpp"

#include "firmware/link/message.hpp"
#include "host/counted.hpp"

namespace kfast::fit {
namespace {

/// The pen is lifted between strokes.
LinkUpdate update_of(const InputView& input)
{
    const auto& [strokes, points, usual] = input.drawing;
    return {std::string{input.name} + ", " + counted(points, "point") + " in " + counted(strokes, "stroke"),
            link::reports_of_drawing(points + strokes - 1)};
}

}

std::vector<LinkUpdate> link_need(const SceneView& scene)
{
    std::size_t numbers = 0;
    std::vector<LinkUpdate> drawings;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const InputView input = inputs.next();
        if (input.type == InputType::drawing)
            drawings.push_back(update_of(input));
        else
            ++numbers;
    }
    std::vector<LinkUpdate> all;
    if (numbers != 0)
        all.push_back({counted(numbers, "number"), (numbers + link::Inputs::most - 1) / link::Inputs::most});
    all.insert(all.end(), drawings.begin(), drawings.end());
    return all;
}

}
