#pragma once

#include "core/beam/beam_profile.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// Where a beam is, sample by sample, once along a picture. Whether it shines, a sound card cannot tell.
using Tour = std::vector<FieldPoint>;

Tour tour_of(std::span<const BeamPoint> points);

/// In units of the field.
double distance(FieldPoint from, FieldPoint to);

/// What has to lie between two points so that no step is longer than `step`; 0: nothing, the beam jumps.
Tour travel(FieldPoint from, FieldPoint to, std::uint32_t step);

/// `count` points, at least as many as `tour` has, evenly spread along the way from its beginning to `next`,
/// where the beam is afterwards. No step is longer than the longest one before.
Tour stretched(std::span<const FieldPoint> tour, FieldPoint next, std::size_t count);

}
