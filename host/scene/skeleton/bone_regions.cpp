#include "host/scene/skeleton/bone_regions.hpp"

#include <algorithm>

namespace kfast::scene {

BoneRegions::BoneRegions(const Skeleton& skeleton)
{
    const std::vector<BoneFrame> frames = frames_as_set_up(skeleton.bones.bones);
    for (std::size_t i = 0; i < frames.size(); ++i)
        regions_.push_back({frames[i].origin, frames[i].tip(), skeleton.regions[i]});
}

std::vector<WeightedBone> BoneRegions::around(Vec2 spot) const
{
    std::vector<WeightedBone> bones;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        const double away = distance_to(regions_[i], spot);
        if (away >= regions_[i].radius)
            continue;
        const double share = away / regions_[i].radius;
        const double fall = 1 - share * share;
        bones.push_back({i, fall * fall});
    }
    return bones;
}

std::size_t BoneRegions::nearest(Vec2 spot) const
{
    const auto nearest = std::ranges::min_element(
        regions_, {}, [&](const Region& region) { return distance_to(region, spot); });
    return static_cast<std::size_t>(nearest - regions_.begin());
}

double BoneRegions::distance_to(const Region& region, Vec2 spot)
{
    return distance_to_line(spot, region.from, region.to);
}

}
