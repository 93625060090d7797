#pragma once

#include "host/art/animation/animated.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"

#include <vector>

namespace kfast::lottie {

/// How a line is broken.
struct Dashes {
    std::vector<art::Channel> lengths; ///< of dashes and gaps by turns, in pixels; none: it is not
    art::Channel offset = {0};         ///< how far into the pattern the line begins, in pixels
};

/// The most dashes of a drawing, and of one that changes or whose dashes move.
inline constexpr int max_dashes = 1000;
inline constexpr int max_moving_dashes = 120;

/// What became of dashes.
enum class Dashing {
    all,         ///< there they are
    stand_still, ///< too many to move: they stay where they are at first
    none,        ///< too many: the line is whole
};

struct DashedDrawing {
    MovingDrawing drawing;
    Dashing dashing = Dashing::all;
};

/// Pieces of the outlines, each of which begins the pattern anew.
DashedDrawing dashed(MovingDrawing drawing, const Dashes& dashes);

}
