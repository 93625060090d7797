#pragma once

#include "core/raster/outline/grid.hpp"

#include <cstdint>

namespace kfast::raster {

/// How far a corner that is left out is from the edge that replaces its two, in the grid, to a few
/// hundredths.
inline constexpr std::int32_t simplify_tolerance = 3;

/// Leaves out corners of a closed contour, as many as follow each other nearly in a straight line:
///
///       ___.----.___               ____________
///      /            \      ->     /            \      each within the tolerance of the new edge
///
/// Returns the end of those that are left. The first and the last corner stay.
[[gnu::cold, gnu::noinline]] Corner* simplify(Corner* first, Corner* end);

/// The maximum length of edges of such a contour in either direction.
inline constexpr std::int32_t max_far_edge = 250 * grid;

/// A contour that was written anew.
struct CutContour {
    Corner* end = nullptr;  ///< null if there was no room
    Corner* peak = nullptr; ///< the end of all memory that was written to
};

/// Moves what is outside of the box with these corners to its borders, and divides long edges; what the
/// contour encloses within the box stays as it is. The contour is between `first` and `end`; there
/// is room for more corners after it, up to `limit`.
[[gnu::cold, gnu::noinline]] CutContour cut_far_contour(Corner* first, Corner* end, Corner* limit,
                                                        Corner upper_left, Corner lower_right);

}
