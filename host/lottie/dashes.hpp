#pragma once

#include "host/art/animated.hpp"
#include "host/lottie/moving_drawing.hpp"

#include <vector>

namespace kfast::lottie {

/// How a line is broken.
struct Dashes {
    std::vector<art::Channel> lengths; ///< of dashes and gaps by turns, in pixels; none: it is not
    art::Channel offset = {0};         ///< how far into the pattern the line begins, in pixels
};

/// The most dashes of a drawing; one that needs more stays whole.
inline constexpr int most_dashes = 1000;

/// Pieces of the outlines, each of which begins the pattern anew. What needs more than most_dashes stays
/// whole.
MovingDrawing dashed(MovingDrawing drawing, const Dashes& dashes);

/// Whether a drawing needs more dashes than it may have, at one of the moments it comes from.
bool has_too_many(const MovingDrawing& drawing, const Dashes& dashes);

}
