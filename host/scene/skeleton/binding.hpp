#pragma once

#include "host/scene/model.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// Before rounding; weights of one point may have any sum above 0.
struct WeightedBone {
    std::size_t bone = 0;
    double weight = 0; ///< 0 or more
};

/// The heaviest of `bones`, at most as many as the format holds; of equals the first. At least one has a
/// weight. Weights are rounded to 1/256 so that their sum is 1: down, and what is missing goes to those that
/// lost most. Bones that are left with nothing are left out.
Binding bound(std::vector<WeightedBone> bones);

/// At a share of the way from `a` to `b`.
Binding mixed(const Binding& a, const Binding& b, double share);

}
