#pragma once

#include <cmath>
#include <cstdint>

namespace kfast::scene {

/// Coordinates reach this many pixels to either side of the canvas' origin.
inline constexpr double coordinate_limit = 2047;

/// False for NaN, too.
constexpr bool in_range(double pixels) { return pixels >= -coordinate_limit && pixels <= coordinate_limit; }

/// Pixels in 1/16, rounded half away from zero. Only for pixels that are in_range().
inline std::int16_t to_sixteenths(double pixels)
{
    return static_cast<std::int16_t>(std::lround(pixels * 16));
}

}
