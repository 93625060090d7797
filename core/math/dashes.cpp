#include "core/math/dashes.hpp"

#include "core/math/fixed.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::uint32_t dot_length = 64; ///< in 1/4096 px

std::uint32_t length_of(std::int32_t fine)
{
    return static_cast<std::uint32_t>(rounded_shift(std::max<std::int32_t>(fine, 0), 2));
}

}

Dashes Dashes::of(std::span<const std::int32_t> lengths, std::int32_t offset, bool has_dots)
{
    Dashes dashes;
    for (const std::int32_t length : lengths)
        dashes.period += dashes.lengths[dashes.count++] = length_of(length);
    dashes.count += dashes.count % 2;
    if (dashes.period == 0)
        return {};
    const std::int32_t rest = rounded_shift(offset, 2) % static_cast<std::int32_t>(dashes.period);
    dashes.offset = static_cast<std::uint32_t>(rest) + (rest < 0 ? dashes.period : 0);
    for (std::uint32_t i = 0; has_dots && i < dashes.count; i += 2) {
        const std::uint32_t short_of = dot_length - std::min(dashes.lengths[i], dot_length);
        const std::uint32_t taken = std::min(short_of, dashes.lengths[i + 1]);
        dashes.lengths[i] += taken;
        dashes.lengths[i + 1] -= taken;
    }
    return dashes;
}

Dashes::Place Dashes::at(std::uint32_t length) const
{
    std::uint32_t rest = (length % period + offset) % period;
    Place place;
    while (rest >= lengths[place.index])
        rest -= lengths[place.index++];
    place.left = lengths[place.index] - rest;
    return place;
}

}
