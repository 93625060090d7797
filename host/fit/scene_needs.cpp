#include "host/fit/scene_needs.hpp"

#include "core/scene/kfb_limits.hpp"
#include "firmware/link/input_message.hpp"
#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <numeric>

namespace kfast::fit {

namespace {

/// By the compiler's figures for the deepest scene: docs/design.md, "The bound on memory".
constexpr std::size_t stack_bound = 6144;

std::size_t sum_of(const std::vector<Reserved>& parts, std::size_t Reserved::*bytes)
{
    return std::accumulate(parts.begin(), parts.end(), std::size_t{},
                           [bytes](std::size_t sum, const Reserved& part) { return sum + part.*bytes; });
}

}

std::size_t Target::reserved_flash() const { return sum_of(reserved, &Reserved::flash); }

std::size_t Target::reserved_ram() const { return sum_of(reserved, &Reserved::ram); }

std::size_t player_code(FeatureSet features, Processor processor)
{
    const ProcessorCosts& costs = costs_of(processor);
    std::size_t code = costs.bare_code;
    for (const Feature feature : features_in(features))
        code += costs.feature_code[static_cast<std::size_t>(feature)];
    return std::min(code, costs.code); // code that several of them have in common was counted for each
}

FlashNeed flash_need(const SceneView& scene, const Target& target)
{
    if (target.has_every_feature)
        return {costs_of(target.processor).code, scene.size(), target.reserved_flash()};
    const FeatureSet features = scene.needed_features();
    return {player_code(features, target.processor), scene.size(), target.reserved_flash(), features};
}

RamNeed ram_need(const SceneView& scene, const Target& target)
{
    const ProcessorCosts& costs = costs_of(target.processor);
    return {Player::block_bytes(scene, target.display.size), 2 * target.band_bytes, costs.fixed_ram,
            std::max(costs.stack, stack_bound), target.reserved_ram()};
}

std::size_t min_band(const Display& display)
{
    return row_bytes(display.format, display.size.width) *
           static_cast<std::size_t>(display.granularity.height);
}

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
