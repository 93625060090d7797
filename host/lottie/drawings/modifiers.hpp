#pragma once

#include "host/lottie/drawings/moving_drawing.hpp"

#include <vector>

namespace kfast::lottie {

/// Which part of a path is left.
struct Trim {
    art::Channel start = {0};       ///< fraction of the length, 0 to 1
    art::Channel end = {1};         ///< the same; may be the smaller one
    art::Channel offset = {0};      ///< fraction of the length, any; 1 is once around
    bool one_after_another = false; ///< all paths count as one, in their order; otherwise each by itself
};

/// Replaces each of the drawings by what is left of it. Where the end of an open path is passed, there are
/// two pieces; a closed one is one, through its beginning.
void trim(const Trim& trim, const std::vector<MovingDrawing*>& drawings);

/// Corners without tangents become arcs of that radius, each at most as far as the middle of its sides. The
/// ends of open outlines stay.
MovingDrawing with_rounded_corners(MovingDrawing drawing, const art::Channel& radius);

}
