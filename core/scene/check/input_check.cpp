#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {
namespace {

bool is_value(std::int32_t value) { return value >= -kfb::max_input_value && value <= kfb::max_input_value; }

bool is_sound_number(const InputView& input)
{
    return is_value(input.least) && is_value(input.most) && input.most > input.least &&
           input.usual >= input.least && input.usual <= input.most;
}

bool is_sound(const TextInput& text)
{
    const auto is_glyph = [&text](std::byte glyph) {
        return std::to_integer<std::uint32_t>(glyph) < text.glyphs.count();
    };
    return text.most >= 1 && text.most <= kfb::max_text && text.glyphs.is_sound() &&
           text.usual.size() <= text.most && std::ranges::all_of(text.usual, is_glyph);
}

bool is_sound(const InputView& input)
{
    switch (input.type) {
    case InputType::number:
        return is_sound_number(input);
    case InputType::drawing:
        return input.drawing.strokes >= 1 && input.drawing.strokes <= input.drawing.points &&
               input.drawing.points <= kfb::max_live_points;
    case InputType::text:
        return is_sound(input.text);
    }
    return false;
}

}

bool inputs_are_sound(const SceneView& scene)
{
    InputCursor inputs = scene.inputs();
    while (!inputs.at_end()) {
        const InputView input = inputs.next();
        if (inputs.rest().overrun() || input.name.empty() || !is_sound(input))
            return false;
    }
    return scene.input_count() <= kfb::max_inputs && inputs.rest().left() == 0;
}

}
