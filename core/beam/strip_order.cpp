#include "core/beam/strip_order.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {
namespace {

/// 2^bits is the power of two nearest to the square root of a third of the number of lines, at most 2^7.
int strip_bits_for(std::size_t lines)
{
    int bits = 0;
    while (bits < 7 && (std::size_t{3} << 2 * (bits + 1)) <= 2 * lines)
        ++bits;
    return bits;
}

/// The number of the strip, and behind it the place in it.
std::uint16_t place_in_strips(FieldPoint at, int strip_bits)
{
    const int place_bits = 16 - strip_bits;
    const auto strip = static_cast<std::uint32_t>(at.y - field_min) >> place_bits;
    const auto across = static_cast<std::uint32_t>(at.x - field_min) >> strip_bits;
    const std::uint32_t mask = (1U << place_bits) - 1;
    return static_cast<std::uint16_t>(strip << place_bits | (strip % 2 == 0 ? across : mask - across));
}

}

void order_by_strips(const BeamLines& lines, std::span<BeamLeg> legs)
{
    const int strip_bits = strip_bits_for(legs.size());
    for (std::size_t number = 0; number < legs.size(); ++number) {
        const FieldPoint at = lines.points(lines.line(number)).front();
        legs[number] = {static_cast<std::uint16_t>(number), place_in_strips(at, strip_bits)};
    }
    const auto is_before = [](const BeamLeg& a, const BeamLeg& b) {
        return a.start != b.start ? a.start < b.start : a.line < b.line;
    };
    std::make_heap(legs.begin(), legs.end(), is_before);
    std::sort_heap(legs.begin(), legs.end(), is_before);
    for (BeamLeg& leg : legs)
        leg.start = 0;
}

}
