#pragma once

#include "host/scene/outline.hpp"

namespace kfast::scene {

/// What lies between two directions from the centre of an ellipse whose axes lie along x and y. Degrees, from
/// three o'clock, clockwise on the screen; where `to` is less than `from` it runs the other way round.
struct Sector {
    Spot centre;
    double radius_x = 0;
    double radius_y = 0;
    double from = 0;
    double to = 0;
};

/// Along the ellipse, open, in cubics of at most a quarter of a turn.
Outline arc(const Sector& sector);

/// From the centre to the ellipse, along it, and back to the centre.
Outline pie(const Sector& sector);

/// Along the ellipse, and back along the circle of radius `inner` about the same centre.
Outline ring_piece(const Sector& sector, double inner);

}
