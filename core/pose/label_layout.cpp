#include "core/pose/label_layout.hpp"

#include "core/bytes/code_point.hpp"
#include "core/bytes/expects.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {

namespace {

constexpr std::int32_t sixteenth = kfb::advance_one / 16;

std::uint32_t number(std::byte glyph) { return std::to_integer<std::uint32_t>(glyph); }

}

LabelLayout::LabelLayout(const LabelView& label, std::span<const std::byte> glyphs)
    : label_{label}, rest_{glyphs}, x_{label.x * sixteenth}
{
    if (label.align == Align::left)
        return;
    std::int32_t width = 0;
    for (; !at_end(); rest_ = rest_.subspan(1))
        width += step();
    rest_ = glyphs;
    x_ -= label.align == Align::center ? width / 2 : width;
}

PlacedGlyph LabelLayout::next()
{
    expects(!at_end());
    const std::int32_t x = rounded_shift(x_, 8);
    static_assert(sixteenth == 1 << 8);
    const PlacedGlyph placed{static_cast<std::uint32_t>(label_.drawings[number(rest_[0])]),
                             {Fixed::sixteenths(x), Fixed::sixteenths(label_.y)}};
    x_ += step();
    rest_ = rest_.subspan(1);
    return placed;
}

/// The distance from the first of the rest to the beginning of the next one, or to the end of the text.
std::int32_t LabelLayout::step() const
{
    const std::uint32_t glyph = number(rest_[0]);
    const std::int32_t advance = label_.advances[glyph];
    if (rest_.size() == 1)
        return advance;
    return advance + label_.spacing + label_.kerning_between(glyph, number(rest_[1]));
}

Point LabelTrace::start() const
{
    for (LabelLayout layout{label_, glyphs()}; !layout.at_end();) {
        const PlacedGlyph glyph = layout.next();
        PackedDrawing drawing{drawings_, glyph.drawing, glyph.origin};
        if (drawing.strokes() == 0)
            continue;
        drawing.next_stroke();
        return drawing.start();
    }
    return {};
}

namespace {

/// Includes the number of glyphs.
std::size_t bytes_of(const InputView& input)
{
    return input.type == InputType::text ? 1 + input.text.max : 0;
}

/// A text in memory.
struct TextPlace {
    TextInput input;
    std::span<std::byte> bytes; ///< none if the input is no text
};

TextPlace place_of(InputCursor inputs, std::uint32_t number, std::span<std::byte> memory)
{
    std::size_t before = 0;
    for (; number > 0; --number)
        before += bytes_of(inputs.next());
    const InputView input = inputs.next();
    return {input.text, memory.subspan(before, bytes_of(input))};
}

/// Sets the byte. Returns whether that changes it.
bool replace(std::byte& byte, std::size_t value)
{
    const auto fresh = static_cast<std::byte>(value);
    const bool changes = byte != fresh;
    byte = fresh;
    return changes;
}

}

std::size_t InputTexts::bytes_for(const SceneView& scene)
{
    std::size_t bytes = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        bytes += bytes_of(inputs.next());
    return bytes;
}

InputTexts::InputTexts(const SceneView& scene, std::span<std::byte> memory) : memory_{memory}
{
    std::ranges::fill(memory, std::byte{}); // put() compares with what was there, also behind a shorter text
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const InputView input = inputs.next();
        if (input.type != InputType::text)
            continue;
        memory[0] = static_cast<std::byte>(input.text.default_value.size());
        std::ranges::copy(input.text.default_value, memory.begin() + 1);
        memory = memory.subspan(bytes_of(input));
    }
}

std::span<const std::byte> InputTexts::glyphs(const SceneView& scene, std::uint32_t number) const
{
    const std::span<const std::byte> bytes = place_of(scene.inputs(), number, memory_).bytes;
    return bytes.subspan(1, std::to_integer<std::size_t>(bytes[0]));
}

bool InputTexts::put(const SceneView& scene, std::uint32_t number, std::string_view text)
{
    const auto [input, bytes] = place_of(scene.inputs(), number, memory_);
    if (bytes.empty())
        return false;
    std::size_t count = 0;
    bool changes = false;
    for (std::size_t at = 0; at < text.size() && count < input.max;) {
        const CodePoint point = code_point_at(text, at);
        at += point.length;
        const auto glyph = point.valid ? input.glyphs.glyph(point.value) : std::nullopt;
        if (glyph)
            changes = replace(bytes[++count], *glyph) || changes;
    }
    return replace(bytes[0], count) || changes;
}

}
