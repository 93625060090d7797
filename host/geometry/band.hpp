#pragma once

#include "host/geometry/outline.hpp"

#include <span>
#include <vector>

namespace kfast::scene {

/// The points beside a line of nodes, one for each of them.
struct BandSides {
    std::vector<Vec2> left; ///< as seen along the nodes, y down
    std::vector<Vec2> right;
};

/// The sides of a band as wide as `widths` says for each of `nodes`, of which there are at least two and no
/// two neighbours coincide. They are perpendicular to the mean direction of the segments beside a node,
/// further away where the band bends, so that it keeps its width; at most twice as far.
BandSides sides_of_band(std::span<const Vec2> nodes, std::span<const double> widths);

}
