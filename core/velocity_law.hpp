#pragma once

#include "core/fixed.hpp"

#include <cstdint>

namespace kfast {

/// How the share of the way between two keys follows from the share of the time. The values are those of the
/// scene format.
enum class VelocityLaw : std::uint8_t {
    constant,              ///< u
    accelerate,            ///< 1 - cos(pi u / 2)
    decelerate,            ///< sin(pi u / 2)
    accelerate_decelerate, ///< (1 - cos(pi u)) / 2
};

inline constexpr int velocity_law_count = 4;

/// The share of the way at the share `time` of the time. Rounded once, within 0.51 units of 1/65536 of the
/// exact value; never falls; 0 at 0 and 1 at 1.
Share progress(VelocityLaw law, Share time);

}
