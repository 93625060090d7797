#pragma once

#include "core/math/point.hpp"

#include <span>
#include <vector>

namespace kfast {

/// One half of a Gaussian with that standard deviation in pixels, from its middle outwards. The whole of it
/// sums up to 1.
std::vector<float> gaussian(double deviation);

/// Spreads each value of a plane, row by row, by the kernel in both directions. What falls beyond the edges
/// is lost.
void blur(std::span<float> plane, Size size, std::span<const float> half_kernel);

/// The same with a square of 2 * `reach` + 1 pixels a side, in a time that does not depend on it. Three times
/// in a row it is much like a Gaussian.
void blur_by_box(std::span<float> plane, Size size, int reach);

}
