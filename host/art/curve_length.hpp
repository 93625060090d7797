#pragma once

#include "host/scene/outline.hpp"

namespace kfast::art {

/// Of a curve that begins at `from`, in pixels: right to 1/100,000 of it, sharp turns left aside.
double curve_length(scene::Spot from, const scene::Curve& curve);

/// Without the line that closes it.
double outline_length(const scene::Outline& outline);

/// The point at a share of the length of an outline with at least one curve; its ends beyond 0 and 1.
scene::Spot spot_along(const scene::Outline& outline, double share);

}
