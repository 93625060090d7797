#pragma once

#include "core/beam/beam_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Lengths and places in the field as a person writes them: in percent of the field's width.
namespace kfast {

inline constexpr double units_per_percent = field_side / 100.0;

/// Rounded to nearest, and to the nearest one that there is; a step of 0 % alone is none.
inline std::uint16_t field_step(double percent)
{
    const long min = percent > 0 ? 1 : 0;
    return static_cast<std::uint16_t>(std::clamp(std::lround(percent * units_per_percent), min, 0xFFFFL));
}

/// Likewise; 0 % is the middle.
inline std::int16_t field_place(double percent)
{
    return static_cast<std::int16_t>(
        std::clamp(std::lround(percent * units_per_percent), long{field_min}, long{field_max}));
}

}
