#include "core/input_view.hpp"

#include "core/name_reader.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::uint32_t number_kind = 0;

}

Time InputView::place_of(std::int32_t value) const
{
    const std::uint32_t range = static_cast<std::uint32_t>(most) - static_cast<std::uint32_t>(least);
    const auto above =
        static_cast<std::uint32_t>(std::clamp(value, least, most)) - static_cast<std::uint32_t>(least);
    const std::uint64_t whole = static_cast<std::uint32_t>(whole_input.ticks);
    return {static_cast<std::int32_t>((above * whole + range / 2) / range)};
}

InputView InputCursor::next()
{
    --left_;
    if (bytes_.u8() != number_kind)
        bytes_.refuse();
    InputView input;
    input.name = read_name(bytes_);
    input.least = bytes_.signed_varint();
    input.most = bytes_.signed_varint();
    input.usual = bytes_.signed_varint();
    return input;
}

void put_usual_places(InputCursor inputs, std::span<Time> places)
{
    for (Time& place : places) {
        const InputView input = inputs.next();
        place = input.place_of(input.usual);
    }
}

}
