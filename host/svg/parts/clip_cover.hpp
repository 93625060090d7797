#pragma once

#include "host/art/geometry/drawing.hpp"

#include <optional>
#include <span>
#include <vector>

namespace kfast::svg {

/// Of a drawing of one convex outline: each curve of it as 16 lines. Nothing of others.
std::optional<std::vector<scene::Vec2>> convex_corners(const art::Drawing& drawing);

/// Whether all of the places lie in the area of a drawing, up to 1/100 px. Only for drawings of one convex
/// outline; of others it is false, since nobody has asked for more.
bool covers(const art::Drawing& area, std::span<const scene::Vec2> places);

}
