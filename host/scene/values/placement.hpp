#pragma once

#include "host/geometry/outline.hpp"
#include "host/scene/values/item_values.hpp"

namespace kfast::scene {

/// Where a copy of a drawing goes: grown and turned about (0, 0), then moved.
class Placement {
public:
    /// Uses the place, rotation and scale of `values`.
    explicit Placement(const ItemValues& values);

    Spot of(Spot spot) const;
    Outline of(const Outline& outline) const;

private:
    Spot origin_;
    Spot x_axis_; ///< where (1, 0) goes, without the move
    Spot y_axis_;
};

}
