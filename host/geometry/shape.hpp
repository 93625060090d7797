#pragma once

#include "host/geometry/outline.hpp"

#include <span>

namespace kfast::scene {

/// From three o'clock, clockwise on the screen, in four cubics (off by at most 0.03 % of the radius).
Outline ellipse(Vec2 centre, double radius_x, double radius_y);

/// From its upper left corner, clockwise. As in SVG, `corner` is cut to half of the width in x and half of
/// the height in y, each by itself.
Outline rectangle(Vec2 upper_left, double width, double height, double corner);

/// Straight lines through `spots`, of which there is at least one.
Outline polyline(std::span<const Vec2> spots, bool closed);

}
