#pragma once

#include "host/art/drawing.hpp"

#include <span>

namespace kfast::svg {

/// Whether all of the places lie in the area of a drawing, up to 1/100 px. Only for drawings of one convex
/// outline; of others it is false, since nobody has asked for more.
bool covers(const art::Drawing& area, std::span<const scene::Spot> places);

}
