#pragma once

#include "host/art/animation/animated.hpp"
#include "host/geometry/outline.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace kfast::art {

/// Points that change together; always the same number of them.
struct Spots {
    std::vector<scene::Vec2> list;
};

Spots mixed(const Spots& from, const Spots& to, double share);

/// What of a function of time is baked, and how well.
struct Baking {
    /// How shortly before a critical time the function is sampled for the value that it jumps from, in
    /// frames: the scene's own resolution of time.
    static constexpr double jump = 1.0 / 1024;

    double from = 0; ///< frames
    double to = 0;   ///< not before `from`
    /// When the function jumps, or its curve has a kink: the keys of what it is made of. In any order.
    std::vector<double> critical;
    double tolerance = 0;          ///< above 0
    std::size_t max_keys = 65'535; ///< the most that the scene allows an item
};

/// Returns linear keys (or hold keys, where the function jumps) that are never further from the function than
/// the tolerance, in each coordinate by itself. The function is sampled at least every quarter of a frame,
/// and up to every 1/64 where it is curved; if that is too much (2^27 points in all), less often. At a jump
/// it already has the new value. Throws Failure if more than `max_keys` are needed.
Animated<Spots> baked_spots(const std::function<Spots(double)>& spots_at, const Baking& baking);

}
