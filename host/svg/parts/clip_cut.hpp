#pragma once

#include "host/art/geometry/drawing.hpp"

#include <span>

namespace kfast::svg {

/// What a filled drawing has inside of a convex area with these corners, in either direction. Its outlines
/// are closed, and have lines along the edges of the area where something was cut off.
art::Drawing cut(const art::Drawing& drawing, std::span<const scene::Vec2> area);

}
