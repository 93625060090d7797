#pragma once

#include "host/geometry/outline.hpp"

#include <vector>

namespace kfast::scene {

/// The point of the circle of radius 1 about (0, 0) at an angle: from three o'clock, clockwise on the screen.
/// Exact at whole quarters of a turn, and symmetrical about them.
Vec2 on_unit_circle(double degrees);

/// How many cubics an arc of that many quarters of a turn takes: at most a quarter each, and at least one.
int arc_pieces(double quarters);

/// Along the unit circle from `from` to `to`, both of which lie on it, `radians` apart: at most a quarter of
/// a turn, clockwise when positive. Off by at most 0.03 % of the radius.
Curve unit_arc(Vec2 from, Vec2 to, double radians);

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
/// own start is a line of length 0.
std::vector<Curve> curves_of(const Arc& arc);

/// An open outline along the ellipse, in cubics of at most a quarter of a turn.
Outline arc(const Sector& sector);

/// An outline from the centre to the ellipse, along it, and back to the centre.
Outline pie(const Sector& sector);

/// An outline along the ellipse, and back along the circle of radius `inner` about the same centre.
Outline ring_piece(const Sector& sector, double inner);

}
