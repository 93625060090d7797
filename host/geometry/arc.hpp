#pragma once

#include "host/geometry/outline.hpp"

#include <vector>

namespace kfast::scene {

/// The arc of SVG's path command A: a piece of an ellipse between two given points.
struct Arc {
    Vec2 from;
    Vec2 to;
    double radius_x = 0;
    double radius_y = 0;
    double rotation = 0; ///< of the ellipse's x axis, degrees, clockwise on the screen
    bool large = false;  ///< more than half of the ellipse
    bool sweep = false;  ///< clockwise on the screen
};

/// Cubics of at most a quarter turn each; the last ends exactly at `to`. By SVG's rules: negative radii count
/// as positive, radii too small for the distance grow, and a radius of 0 gives a straight line. An arc to its
/// own start goes nowhere: a line of no length.
std::vector<Curve> curves_of(const Arc& arc);

}
