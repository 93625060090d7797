#pragma once

#include "host/geometry/outline.hpp"

#include <vector>

namespace kfast::art {

/// Strokes of one shape; filled together, by one rule.
struct Drawing {
    std::vector<scene::Outline> outlines;
};

bool operator==(const Drawing& left, const Drawing& right);

/// Whether both have the same numbers of outlines and of curves in each, so that they tween point by point.
bool same_form(const Drawing& left, const Drawing& right);

/// The curve, which begins at `from`, as a cubic; of a line, with its control points at thirds.
scene::Curve as_cubic(scene::Vec2 from, const scene::Curve& curve);

/// Point by point; lines become cubics where the other is one. Of drawings that have not the same form, the
/// first until the share is 1: only the scene's own player can tween those.
Drawing mixed(const Drawing& from, const Drawing& to, double share);

}
