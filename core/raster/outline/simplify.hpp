#pragma once

#include "core/raster/outline/grid.hpp"

#include <cstdint>

namespace kfast::raster {

/// How far a corner that is left out lies from the edge that replaces its two, in the grid, to a few
/// hundredths.
inline constexpr std::int32_t simplify_tolerance = 3;

/// Leaves out corners of a closed contour, as many as follow each other nearly in a straight line:
///
///       ___.----.___               ____________
///      /            \      ->     /            \      each within the tolerance of the new edge
///
/// Returns the end of those that are left. The first and the last corner stay.
[[gnu::cold, gnu::noinline]] Corner* simplify(Corner* first, Corner* end);

}
