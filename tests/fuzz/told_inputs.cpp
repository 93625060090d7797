#include "tests/fuzz/told_inputs.hpp"

#include "core/scene/input_view.hpp"
#include "host/text/characters.hpp"
#include "tests/demand.hpp"

#include <string>

namespace kfast::test {
namespace {

Time place_of(std::uint32_t round)
{
    return {static_cast<std::int32_t>(round * 9973 % static_cast<std::uint32_t>(whole_input.ticks + 1))};
}

std::string words(const GlyphSet& glyphs, std::uint32_t round)
{
    std::string text;
    for (std::uint32_t i = 0; i < 70; ++i)
        if (const char32_t character = glyphs.character((round * 31 + i * (round % 3)) % glyphs.count());
            is_scalar_value(character))
            append_utf8(text, character);
    return text;
}

void scribble(SceneState& state, std::uint32_t input, std::uint32_t max, std::uint32_t seed)
{
    InputDrawing drawing = state.drawing(input);
    drawing.begin();
    for (std::uint32_t left = seed * 31 % (max + 2); left > 0; --left) {
        seed = seed * 1664525 + 1013904223;
        if (seed >> 28 == 0)
            drawing.begin_stroke();
        drawing.add({static_cast<std::int16_t>(seed >> 8), static_cast<std::int16_t>(seed >> 16)});
    }
    state.show_next_drawing(input);
}

}

void tell_inputs(SceneState& state, std::uint32_t round)
{
    std::uint32_t number = 0;
    for (InputCursor inputs = state.scene().inputs(); !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type == InputType::number)
            state.set_input(number, place_of(round + number));
        else if (input.type == InputType::text)
            state.set_text(number, round % 4 == 3 ? "" : words(input.text.glyphs, round));
        else
            scribble(state, number, input.drawing.points, round);
    }
}

}
