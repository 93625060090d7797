#pragma once

#include "host/geometry/outline.hpp"

namespace kfast::scene {

/// The point of the circle of radius 1 about (0, 0) at an angle: from three o'clock, clockwise on the screen.
/// Exact at whole quarters of a turn, and symmetrical about them.
Vec2 on_unit_circle(double degrees);

/// How many cubics an arc of so many quarters of a turn takes: at most a quarter each, and at least one.
int arc_pieces(double quarters);

/// Along the unit circle from `from` to `to`, which both lie on it, `radians` apart: at most a quarter of a
/// turn, clockwise when positive. Off by at most 0.03 % of the radius.
Curve unit_arc(Vec2 from, Vec2 to, double radians);

}
