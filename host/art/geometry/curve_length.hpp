#pragma once

#include "host/geometry/outline.hpp"

namespace kfast::art {

/// Of a curve that begins at `from`, in pixels: right to 1/100,000 of it, sharp turns left aside.
double curve_length(scene::Vec2 from, const scene::Curve& curve);

/// The parameter, 0 to 1, of its point at a length from its beginning; its ends beyond them.
double curve_parameter(scene::Vec2 from, const scene::Curve& curve, double length);

/// Its point at a parameter, 0 to 1.
scene::Vec2 spot_on(scene::Vec2 from, const scene::Curve& curve, double t);

/// Without the line that closes it.
double outline_length(const scene::Outline& outline);

/// The point at a share of the length of an outline with at least one curve; its ends beyond 0 and 1.
scene::Vec2 spot_along(const scene::Outline& outline, double share);

}
