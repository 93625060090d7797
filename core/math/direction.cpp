#include "core/math/direction.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace kfast {
namespace {

/// 2^30 / sqrt(square) for 2^28 … 2^31, at most 1/16000 off.
std::uint32_t inverse_root(std::uint32_t square)
{
    const bool is_large = square >= 1U << 30;
    const std::uint32_t reduced = (is_large ? square : square << 2) >> 16;
    // The line is within 9 % of 2^31 / sqrt for all that is left; each of Newton's steps squares the error.
    std::uint32_t root = 69888 - (reduced * 39 >> 6);
    for (int step = 0; step < 3; ++step) {
        const auto rest = (1 << 30) - static_cast<std::int32_t>(reduced * (root * root >> 16));
        root += static_cast<std::uint32_t>((static_cast<std::int32_t>(root) * (rest >> 15)) >> 16);
    }
    return is_large ? root >> 1 : root;
}

}

// The vector is brought to 15 bits, so that its square fits in 32. Its direction is then within 1/30000 rad,
// and so is what rounding the unit vector adds: together 1/750 px at the edge of a stroke 40 px wide.
PolarVector to_polar(Point vector)
{
    const auto longest =
        static_cast<std::uint32_t>(std::max(std::abs(vector.x.raw()), std::abs(vector.y.raw())));
    const int excess = 17 - std::countl_zero(longest);
    const auto shifted = [excess](std::int32_t value) {
        return excess > 0 ? (value + (1 << (excess - 1))) >> excess : value * (1 << -excess);
    };
    const std::int32_t x = shifted(vector.x.raw());
    const std::int32_t y = shifted(vector.y.raw());
    const auto square = static_cast<std::uint32_t>(x * x) + static_cast<std::uint32_t>(y * y);
    const auto inverse = static_cast<std::int32_t>(inverse_root(square));
    const auto unit = [inverse](std::int32_t value) { return (value * inverse + (1 << 14)) >> 15; };
    const std::uint32_t length = (square >> 15) * static_cast<std::uint32_t>(inverse) >> 15;
    return {{unit(x), unit(y)}, excess > 0 ? length << excess : length >> -excess};
}

}
