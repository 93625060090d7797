#pragma once

#include "host/geometry/outline.hpp"

namespace kfast::scene {

/// A star with `tips` on a circle of radius `outer` and as many dents on one of radius `inner`. From the
/// first tip, at twelve o'clock when `rotation` (degrees, clockwise) is 0; clockwise, closed.
Outline star(Vec2 centre, int tips, double outer, double inner, double rotation);

/// A polygon with equal sides and angles, its corners on a circle. It begins and runs like a star.
Outline regular_polygon(Vec2 centre, int corners, double radius, double rotation);

}
