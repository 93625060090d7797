#include "core/scene/input_view.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/math/fixed.hpp"

#include <algorithm>

namespace kfast {
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

}
