#pragma once

#include "host/art/budget.hpp"
#include "host/geometry/outline.hpp"

#include <span>
#include <vector>

namespace kfast::art {

/// Strokes of one shape; filled together, by one rule.
struct Drawing {
    std::vector<scene::Outline> outlines;
};

bool operator==(const Drawing& left, const Drawing& right);

/// Whether both have the same numbers of outlines and of curves in each, so that they tween point by point.
bool same_form(const Drawing& left, const Drawing& right);

/// The curve, which begins at `from`, as a cubic; a line gets its control points at thirds.
scene::Curve as_cubic(scene::Vec2 from, const scene::Curve& curve);

/// Mixes point by point; lines become cubics where the other is one. For drawings of different form it is the
/// first until `share` is 1: only the scene's own player can tween those.
Drawing mixed(const Drawing& from, const Drawing& to, double share);

/// Cuts the outlines of a drawing as SVG and Lottie dash lines: of the lengths in `pattern`, in pixels, the
/// first is drawn, the second left out, and so on, from the beginning again after the last; of an odd number
/// of them, gaps and dashes alternate each time. Each outline begins `offset` into the pattern. The pieces
/// are open; where a closed outline begins and ends within dashes, these are one.
///
/// Lengths are 0 or more; if all are 0, or there are none, the drawing stays whole. A dash of length 0 is a
/// single closed point, a dot if it has round or square caps. The points are taken from the budget.
Drawing dashed(const Drawing& drawing, std::span<const double> pattern, double offset, Budget& budget);

}
