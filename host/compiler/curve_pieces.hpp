#pragma once

#include "core/segment.hpp"
#include "core/velocity_law.hpp"
#include "host/scene/model.hpp"

#include <cstdint>

namespace kfast {

/// How many straight pieces stand for a curve anywhere on the way from `a` to `b`, if it stays within `x` and
/// `y` and is then enlarged by `scale`, so that none is more than 1/32 px away from its curve; at least 1, at
/// most kfb::max_curve_pieces.
std::uint32_t curve_pieces(const scene::Drawing& a, const scene::Drawing& b, WayRange x, WayRange y,
                           double scale = 1);

/// The second difference of the control points of a curve, in pixels: the longer of two. A line has none.
double bend_of(const Segment& segment);
/// As curve_pieces(), where no curve has a longer one than `bend`.
std::uint32_t pieces_for_bend(double bend, double scale);

}
