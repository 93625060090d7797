#pragma once

#include "host/geometry/outline.hpp"

#include <span>

namespace kfast::scene {

/// A smooth curve through `spots`, of which there is at least one, in the shape of a centripetal Catmull-Rom
/// spline: the knots lie as far apart as the square roots of the spots' distances, so that a curve makes no
/// loop or cusp between two spots however unevenly they lie. A spot that repeats the one before it is left
/// out; two spots of an open curve give a line.
///
/// Between two spots the spline blends the two parabolas that go through three spots each, those two and one
/// neighbour (the pyramid of Barry and Goldman). At its end each of them alone has weight, and there both
/// meet; so the slope at a spot is that of the parabola through it and its neighbours, and a third of it,
/// times the distance of the knots, is the way to the control point of the cubic Bézier, which is the same
/// curve. The first and last piece of an open curve are parabolas: the one that there is.
Outline spline(std::span<const Vec2> spots, bool closed);

}
