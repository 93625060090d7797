#pragma once

#include "core/beam/beam_profile.hpp"

#include <cstdint>
#include <span>

namespace kfast {

/// CRC-32 of the points of a picture, the same on every target for the same scene, time and profile. Of each
/// point 8 bytes: x, then y, each with the low byte first; red, green, blue; 255 where the beam is lit, else
/// 0, as then the colours are.
std::uint32_t hash(std::span<const BeamPoint> points);

}
