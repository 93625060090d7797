#pragma once

#include "host/geometry/outline.hpp"

#include <optional>

namespace kfast::lottie {

/// The tips of a star, its inner corners, or the corners of a polygon.
struct Ring {
    double radius = 0;
    double roundness = 0; ///< 1: handles of a quarter of the arc to the next one
};

/// A star or a polygon of Lottie at one time.
struct Polystar {
    scene::Vec2 centre;
    int tips = 0; ///< or corners
    Ring outer;
    std::optional<Ring> inner; ///< of a star
    double rotation = 0;       ///< degrees, clockwise; at 0, a tip is at twelve o'clock
    bool counterclockwise = false;
};

/// Closed, from the tip that `rotation` is about. Its curves are cubics if `is_round`, whatever the roundness
/// now is.
scene::Outline outline_of(const Polystar& star, bool is_round);

}
