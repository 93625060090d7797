#pragma once

#include "host/scene/item_values.hpp"
#include "host/scene/outline.hpp"

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
