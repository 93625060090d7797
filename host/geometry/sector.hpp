#pragma once

#include "host/geometry/outline.hpp"

namespace kfast::scene {

/// Along the ellipse, open, in cubics of at most a quarter of a turn.
Outline arc(const Sector& sector);

/// From the centre to the ellipse, along it, and back to the centre.
Outline pie(const Sector& sector);

/// Along the ellipse, and back along the circle of radius `inner` about the same centre.
Outline ring_piece(const Sector& sector, double inner);

}
