#include "tests/host/compiler/input_comparison.hpp"

#include "tests/host/compiler/unpacked_drawing.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

void compare_drawing(const SceneView& view, const DrawingInput& read, const scene::DrawingInput& drawing)
{
    CHECK(read.strokes == drawing.strokes);
    CHECK(read.points == drawing.points);
    CHECK(unpacked(view.drawing(read.default_value)) == drawing.default_value);
}

void compare_text(const TextInput& read, const scene::TextInput& text)
{
    CHECK(read.max == text.max);
    REQUIRE(read.glyphs.count() == text.glyphs.size());
    for (std::uint32_t glyph = 0; glyph < read.glyphs.count(); ++glyph)
        CHECK(read.glyphs.character(glyph) == text.glyphs[glyph]);
    REQUIRE(read.default_value.size() == text.default_value.size());
    for (std::size_t i = 0; i < text.default_value.size(); ++i)
        CHECK(read.glyphs.character(std::to_integer<std::uint32_t>(read.default_value[i])) ==
              text.default_value[i]);
}

}

void compare_inputs(const SceneView& view, const std::vector<scene::Input>& inputs)
{
    REQUIRE(view.input_count() == inputs.size());
    InputCursor cursor = view.inputs();
    for (const scene::Input& input : inputs) {
        const InputView read = cursor.next();
        CHECK(read.name == input.name);
        REQUIRE(read.type == input.type);
        if (input.type == InputType::drawing) {
            compare_drawing(view, read.drawing, input.drawing);
        } else if (input.type == InputType::text) {
            compare_text(read.text, input.text);
        } else {
            CHECK(read.min == input.min);
            CHECK(read.max == input.max);
            CHECK(read.default_value == input.default_value);
        }
    }
}

}
