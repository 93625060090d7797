#include "core/scene/input_view.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/code_point.hpp"
#include "core/math/fixed.hpp"
#include "core/scene/format.hpp"

#include <algorithm>

namespace kfast {

GlyphSet GlyphSet::take(ByteReader& bytes)
{
    GlyphSet set;
    set.count_ = bytes.u8();
    const std::size_t stretches = bytes.u8();
    set.stretches_ = bytes.take(kfb::glyph_range::bytes * stretches).rest();
    return set;
}

std::optional<std::uint8_t> GlyphSet::glyph(char32_t character) const
{
    std::uint32_t low = 0; // ranges before it begin at `character` or before
    for (std::uint32_t high = stretches(); low < high;) {
        const std::uint32_t middle = (low + high) / 2;
        if (stretch(middle).character <= character)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0)
        return std::nullopt;
    const Stretch found = stretch(low - 1);
    const std::uint32_t further = character - found.character;
    if (further >= end_of(low - 1) - found.glyph)
        return std::nullopt;
    return static_cast<std::uint8_t>(found.glyph + further);
}

char32_t GlyphSet::character(std::uint32_t glyph) const
{
    std::uint32_t number = 0;
    while (end_of(number) <= glyph)
        ++number;
    const Stretch found = stretch(number);
    return found.character + (glyph - found.glyph);
}

bool GlyphSet::is_valid() const
{
    if (stretches() == 0 || stretch(0).glyph != 0)
        return false;
    for (std::uint32_t number = 0; number < stretches(); ++number) {
        const Stretch here = stretch(number);
        const std::uint32_t end = end_of(number);
        if (end <= here.glyph)
            return false;
        const char32_t beyond = here.character + (end - here.glyph);
        const bool is_last = number + 1 == stretches();
        if (beyond > (is_last ? last_code_point + 1 : stretch(number + 1).character))
            return false;
    }
    return true;
}

GlyphSet::Stretch GlyphSet::stretch(std::uint32_t number) const
{
    const std::uint32_t both = ByteReader{stretches_.subspan(kfb::glyph_range::bytes * number)}.u32();
    return {kfb::glyph_range::glyph.get(both), static_cast<char32_t>(kfb::glyph_range::character.get(both))};
}

std::uint32_t GlyphSet::end_of(std::uint32_t number) const
{
    return number + 1 < stretches() ? stretch(number + 1).glyph : count_;
}

namespace {

TextInput take_text(ByteReader& bytes)
{
    TextInput text;
    text.max = bytes.u8();
    text.glyphs = GlyphSet::take(bytes);
    text.default_value = bytes.take(bytes.u8()).rest();
    return text;
}

}

Time InputView::place_of(std::int32_t value) const
{
    if (type != InputType::number)
        return {};
    const std::uint32_t range = static_cast<std::uint32_t>(max) - static_cast<std::uint32_t>(min);
    const auto above =
        static_cast<std::uint32_t>(std::clamp(value, min, max)) - static_cast<std::uint32_t>(min);
    const std::uint64_t whole = static_cast<std::uint32_t>(whole_input.ticks);
    return {static_cast<std::int32_t>(quotient(above * whole + range / 2, range))};
}

InputView InputCursor::next()
{
    --left_;
    InputView input;
    input.type = static_cast<InputType>(bytes_.u8());
    input.name = read_name(bytes_);
    switch (input.type) {
    case InputType::number:
        input.min = bytes_.signed_varint();
        input.max = bytes_.signed_varint();
        input.default_value = bytes_.signed_varint();
        return input;
    case InputType::text:
        input.text = take_text(bytes_);
        return input;
    case InputType::drawing:
        input.drawing.strokes = bytes_.varint();
        input.drawing.points = bytes_.varint();
        input.drawing.default_value = bytes_.varint();
        return input;
    }
    bytes_.refuse();
    return input;
}

void put_default_places(InputCursor inputs, std::span<Time> places)
{
    for (Time& place : places) {
        const InputView input = inputs.next();
        place = input.place_of(input.default_value);
    }
}

LabelView LabelView::of(ByteReader bytes)
{
    LabelView label;
    label.align = static_cast<Align>(bytes.u8());
    label.x = bytes.signed_varint();
    label.y = bytes.signed_varint();
    label.spacing = bytes.signed_varint();
    label.glyph_count = bytes.u8();
    label.drawings = PackedValues::take(bytes, label.glyph_count);
    label.advances = PackedValues::take(bytes, label.glyph_count);
    const std::size_t pairs = bytes.u16();
    label.pairs = bytes.take(kfb::kerning::bytes * pairs).rest();
    if (pairs != 0)
        label.kerning = PackedValues::take(bytes, label.pair_count());
    label.is_whole = !bytes.overrun() && bytes.left() == 0;
    return label;
}

std::uint32_t LabelView::pair_code(std::uint32_t number) const
{
    return ByteReader{pairs.subspan(kfb::kerning::bytes * number)}.u16();
}

std::int32_t LabelView::kerning_between(std::uint32_t left, std::uint32_t right) const
{
    const std::uint32_t code = kfb::kerning::left.put(left) | kfb::kerning::right.put(right);
    std::uint32_t low = 0; // pairs before it come before `code`
    for (std::uint32_t high = pair_count(); low < high;) {
        const std::uint32_t middle = (low + high) / 2;
        if (pair_code(middle) < code)
            low = middle + 1;
        else
            high = middle;
    }
    return low < pair_count() && pair_code(low) == code ? kerning[low] : 0;
}

}
