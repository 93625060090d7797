#pragma once

#include "host/scene/context/skeleton_table.hpp"
#include "host/scene/skeleton/binding.hpp"
#include "host/scene/skeleton/bone_frames.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// The regions of influence of a skeleton's bones, as set up: all that is nearer to a bone than its radius.
class BoneRegions {
public:
    explicit BoneRegions(const Skeleton& skeleton);

    /// The bones in whose regions `spot` lies. A weight is 1 on the bone and falls smoothly to 0 at the
    /// border.
    std::vector<WeightedBone> around(Vec2 spot) const;
    std::size_t nearest(Vec2 spot) const;

private:
    struct Region {
        Vec2 from;
        Vec2 to;
        double radius;
    };
    static double distance_to(const Region& region, Vec2 spot);

    std::vector<Region> regions_;
};

}
