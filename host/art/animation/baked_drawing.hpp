#pragma once

#include "host/art/animation/baked_spots.hpp"
#include "host/art/geometry/drawing.hpp"

namespace kfast::art {

/// As baked_spots(), for drawings that always have the same form: no point or control point is ever further
/// away than the tolerance. Lines stay lines where they are lines at all times.
Animated<Drawing> baked_drawing(const std::function<Drawing(double)>& drawing_at, const Baking& baking);

/// As baked_spots(), for a number.
Channel baked_channel(const std::function<double(double)>& value_at, const Baking& baking);

/// The x and the y of a point.
struct PlaceChannels {
    Channel x;
    Channel y;
};

/// As baked_spots(), for a point, which is never further away than the tolerance.
PlaceChannels baked_place(const std::function<scene::Vec2(double)>& place_at, const Baking& baking);

}
