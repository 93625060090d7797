#pragma once

#include "host/sound/deflection.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// A WAV file in which these points are played, `rate` a second. `bits` are 16 or 24; levels are rounded.
/// Throws Failure if libsndfile cannot write it.
std::vector<std::byte> wave_file(std::span<const FieldPoint> points, const Deflection& deflection,
                                 std::uint32_t rate, int bits);

}
