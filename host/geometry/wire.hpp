#pragma once

#include "host/geometry/drawing.hpp"

#include <vector>

namespace kfast::scene {

/// A place in the space of an item before rounding, in pixels; z points at the viewer.
struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;
};

/// Straight lines through places, of which there is at least one; closed if the last one is the first.
using Wire = std::vector<Vec3>;

bool in_range(const Wire& wire);

/// A stroke with a depth for each of its points.
struct WireStroke {
    Stroke flat;
    Stroke depths; ///< see Key::depths
};

/// Rounds every point once, to the nearest 1/16 px (halves away from zero). Segments without extent stay, so
/// that the points of two wires keep meeting.
WireStroke quantized(const Wire& wire);

}
