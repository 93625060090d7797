#pragma once

#include "host/geometry/outline.hpp"

#include <span>

namespace kfast::scene {

/// Begins at three o'clock, clockwise on the screen, in four cubics (off by at most 0.03 % of the radius).
Outline ellipse(Vec2 centre, double radius_x, double radius_y);

/// A rectangle from its upper left corner, clockwise. As in SVG, `corner` is limited to half of the width in
/// x and half of the height in y, each by itself.
Outline rectangle(Vec2 upper_left, double width, double height, double corner);

/// Straight lines through `spots`, of which there is at least one.
Outline polyline(std::span<const Vec2> spots, bool closed);

/// A star with `tips` on a circle of radius `outer` and as many inner corners on one of radius `inner`. From
/// the first tip, at twelve o'clock when `rotation` (degrees, clockwise) is 0; clockwise, closed.
Outline star(Vec2 centre, int tips, double outer, double inner, double rotation);

/// A polygon with equal sides and angles, its corners on a circle. It begins and runs as a star does.
Outline regular_polygon(Vec2 centre, int corners, double radius, double rotation);

/// A smooth curve through `spots`, of which there is at least one, in the shape of a centripetal Catmull-Rom
/// spline: the knots are as far apart as the square roots of the points' distances, so that a curve makes no
/// loop or cusp between two points however unevenly they are spaced. A point that repeats the one before it
/// is left out; two points of an open curve give a line.
///
/// Between two points the spline blends the two parabolas that go through three points each, those two and
/// one neighbour (the pyramid of Barry and Goldman). At its end each of them alone has weight, and there both
/// meet; so the slope at a point is that of the parabola through it and its neighbours, and a third of it,
/// times the distance of the knots, is the offset of the control point of the cubic Bézier, which is the same
/// curve. The first and last piece of an open curve are parabolas: the only one there is.
Outline spline(std::span<const Vec2> spots, bool closed);

}
