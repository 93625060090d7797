#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {
namespace {

bool is_value(std::int32_t value) { return value >= -kfb::max_input_value && value <= kfb::max_input_value; }

bool is_valid_number(const InputView& input)
{
    return is_value(input.min) && is_value(input.max) && input.max > input.min &&
           input.default_value >= input.min && input.default_value <= input.max;
}

bool is_valid(const TextInput& text)
{
    const auto is_glyph = [&text](std::byte glyph) {
        return std::to_integer<std::uint32_t>(glyph) < text.glyphs.count();
    };
    return text.max >= 1 && text.max <= kfb::max_text && text.glyphs.is_valid() &&
           text.default_value.size() <= text.max && std::ranges::all_of(text.default_value, is_glyph);
}

bool is_valid(const InputView& input)
{
    switch (input.type) {
    case InputType::number:
        return is_valid_number(input);
    case InputType::drawing:
        return input.drawing.strokes >= 1 && input.drawing.strokes <= input.drawing.points &&
               input.drawing.points <= kfb::max_live_points;
    case InputType::text:
        return is_valid(input.text);
    }
    return false;
}

}

bool are_inputs_valid(const SceneView& scene)
{
    InputCursor inputs = scene.inputs();
    while (!inputs.at_end()) {
        const InputView input = inputs.next();
        if (inputs.rest().overrun() || input.name.empty() || !is_valid(input))
            return false;
    }
    return scene.input_count() <= kfb::max_inputs && inputs.rest().left() == 0;
}

}
