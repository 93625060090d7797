#pragma once

#include "host/geometry/outline.hpp"
#include "host/scene/values/item_values.hpp"

namespace kfast::scene {

/// Where a copy of a drawing goes: grown and turned about (0, 0), then moved.
class Placement {
public:
    /// Uses the place, rotation and scale of `values`.
    explicit Placement(const ItemValues& values);

    Vec2 of(Vec2 spot) const;
    Outline of(const Outline& outline) const;

private:
    Vec2 origin_;
    Vec2 x_axis_; ///< where (1, 0) goes, without the move
    Vec2 y_axis_;
};

}
