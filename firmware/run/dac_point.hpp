#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/pixel/paint_style.hpp"

#include <cstdint>

namespace kfast {

/// A coordinate of the field, 65536 units, in 12 bits: 0 is its lowest value.
constexpr std::uint32_t dac_level(std::int16_t place)
{
    return static_cast<std::uint32_t>(place - field_min) >> 4;
}

/// How bright a point is, 0 … 255; 0: the beam is dark.
constexpr std::uint32_t dac_brightness(const BeamPoint& point, BeamBrightness mode)
{
    if (!point.is_lit())
        return 0;
    return mode == BeamBrightness::by_level ? brightness(point.colour) : 255;
}

/// A point for a DAC of two converters: brightness in the highest 8 bits, 12 of x, 12 of y.
constexpr std::uint32_t dac_point(const BeamPoint& point, BeamBrightness mode)
{
    return dac_brightness(point, mode) << 24 | dac_level(point.at.x) << 12 | dac_level(point.at.y);
}

}
