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
    const std::size_t ranges = bytes.u8();
    set.ranges_ = bytes.take(kfb::glyph_range::bytes * ranges).rest();
    return set;
}

std::optional<std::uint8_t> GlyphSet::glyph(char32_t character) const
{
    std::uint32_t low = 0; // what lies before it begins at `character` or before
    for (std::uint32_t high = ranges(); low < high;) {
        const std::uint32_t middle = (low + high) / 2;
        if (range(middle).character <= character)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0)
        return std::nullopt;
    const GlyphRange found = range(low - 1);
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
    const GlyphRange found = range(number);
    return found.character + (glyph - found.glyph);
}

bool GlyphSet::is_valid() const
{
    if (ranges() == 0 || range(0).glyph != 0)
        return false;
    for (std::uint32_t number = 0; number < ranges(); ++number) {
        const GlyphRange here = range(number);
        const std::uint32_t end = end_of(number);
        if (end <= here.glyph)
            return false;
        const char32_t beyond = here.character + (end - here.glyph);
        const bool is_last = number + 1 == ranges();
        if (beyond > (is_last ? last_code_point + 1 : range(number + 1).character))
            return false;
    }
    return true;
}

GlyphSet::GlyphRange GlyphSet::range(std::uint32_t number) const
{
    const std::uint32_t both = ByteReader{ranges_.subspan(kfb::glyph_range::bytes * number)}.u32();
    return {kfb::glyph_range::glyph.get(both), static_cast<char32_t>(kfb::glyph_range::character.get(both))};
}

std::uint32_t GlyphSet::end_of(std::uint32_t number) const
{
    return number + 1 < ranges() ? range(number + 1).glyph : count_;
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

[[gnu::cold]] NumberFormat NumberFormat::take(ByteReader& bytes)
{
    NumberFormat format;
    format.decimals = bytes.u8();
    const std::uint32_t least = bytes.u8();
    format.digits = kfb::number_format::digits.get(least);
    format.places = kfb::number_format::places.get(least);
    format.before = bytes.take(bytes.u8()).rest();
    format.behind = bytes.take(bytes.u8()).rest();
    return format;
}

LabelView LabelView::of(ByteReader bytes)
{
    LabelView label;
    const std::uint32_t head = bytes.u8();
    label.align = static_cast<Align>(kfb::label::align.get(head));
    label.shows_number = kfb::label::shows_number.get(head);
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
    if (label.shows_number)
        label.format = NumberFormat::take(bytes);
    label.is_whole = !bytes.overrun() && bytes.left() == 0 && kfb::label::unused.get(head) == 0;
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
