#pragma once

#include "host/scene/context/limits.hpp"

#include <cstddef>

namespace kfast::scene {

/// The points that the drawings of a scene may still have. Copies of symbols would soon be more than any
/// memory holds.
class PointBudget {
public:
    /// False when they are too many; then nothing is taken.
    bool take(std::size_t points)
    {
        if (points > left_)
            return false;
        left_ -= points;
        return true;
    }

private:
    std::size_t left_ = max_points_of_scene;
};

}
