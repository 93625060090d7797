#pragma once

#include "host/art/animation/animated.hpp"
#include "host/geometry/outline.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace kfast::art {

/// Places that change together; always the same number of them.
struct Spots {
    std::vector<scene::Vec2> list;
};

Spots mixed(const Spots& from, const Spots& to, double share);

/// What of a function of time is baked, and how well.
struct Baking {
    /// How little before a critical time the function is asked for what it jumps from, in frames: the scene's
    /// own resolution of time.
    static constexpr double jump = 1.0 / 1024;

    double from = 0; ///< frames
    double to = 0;   ///< not before `from`
    /// When the function jumps, or its curve has a bend: the keys of what it is made of. In any order.
    std::vector<double> critical;
    double tolerance = 0;          ///< above 0
    std::size_t max_keys = 65'535; ///< as many as the scene allows an item
};

/// Keys with straight ways between them (or held ones, where the function jumps) that are never further from
/// the function than the tolerance, in each coordinate by itself. The function is asked at least every
/// quarter of a frame, and up to every 1/64 where it is bent; of what is too large for that (2^27 places in
/// all), less often. At a jump it already is what it jumps to. Throws Failure beyond the most keys.
Animated<Spots> baked_spots(const std::function<Spots(double)>& spots_at, const Baking& baking);

}
