#pragma once

#include "core/scene/format.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace kfast::scene {

/// An influence before rounding; the weights of one point may have any sum above 0.
struct WeightedBone {
    std::size_t bone = 0;
    double weight = 0; ///< 0 or more
};

/// The heaviest of `bones`, at most as many as the format holds; the first of equals. At least one has a
/// weight. Weights are rounded to multiples of `unit` (in 1/65536) so that their sum is 1: down, and what is
/// missing goes to those that lost most. Bones that are left with nothing are left out.
Binding bound(std::vector<WeightedBone> bones, int unit = 1);

/// The same in the unit of weights of one byte, which make the smaller files.
inline Binding coarsely_bound(std::vector<WeightedBone> bones)
{
    return bound(std::move(bones), kfb::skin::coarse_weight);
}

/// Interpolates from `a` to `b`.
Binding mixed(const Binding& a, const Binding& b, double share);

}
