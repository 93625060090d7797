#pragma once

#include "host/art/document/document.hpp"
#include "host/art/prepare/tween_turn.hpp"

#include <span>
#include <vector>

namespace kfast::art {

/// A direction of a drawing that its line shows: of what meets at a corner, or of an end.
struct CornerArm {
    std::vector<scene::Vec2> directions; ///< in each key; as long as the handle that gives it
    double factor = 1; ///< how far what is seen moves when the arm turns, in half widths times radians
};

/// Those of a shape whose drawings all have the same form. Round joins and caps show none, nor do joins that
/// are smooth at all times.
std::vector<CornerArm> corner_arms(const Shape& shape);

/// By how much what the line shows moves, at most, when points of the drawing move by 1, at any time: at
/// least 1, and infinite where an arm vanishes.
double corner_motion(std::span<const CornerArm> arms, std::span<const TweenRange> tweens, double half_width);

}
