#pragma once

#include "host/art/document/document.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::scene_text {

/// The maximum coordinates of a scene, in pixels; leaves room for rounding, and for points that are moved
/// beside others.
inline constexpr double widest_reach = 2040;

/// The maximum coordinates of an animation: of positions, paths, drawings and bones, in pixels.
struct Reach {
    double left_alone = 0; ///< as they are without groups that only scale their content up
    double in_groups = 0;  ///< as they are with them; beyond 2047, they are clamped

    void take(const Reach& other)
    {
        left_alone = std::max(left_alone, other.left_alone);
        in_groups = std::max(in_groups, other.in_groups);
    }
};

/// How far a bone's origin may be from the set-up, so that a scene can store its distance from its parent.
inline double room_of(const art::Rig& rig, const art::Bone& bone)
{
    const scene::Vec2 around = bone.parent ? rig.bones[*bone.parent].from : scene::Vec2{};
    const scene::Vec2 offset = bone.from - around;
    return std::max(2047 - std::max(std::abs(offset.x), std::abs(offset.y)), 0.0);
}

/// The reach of bones, as set up and as moved.
inline double reach_of(const art::Rig& rig)
{
    double reach = 0;
    const auto take = [&reach](double coordinate) { reach = std::max(reach, std::abs(coordinate)); };
    for (const art::Bone& bone : rig.bones) {
        for (const double coordinate : {bone.from.x, bone.from.y, bone.to.x, bone.to.y})
            take(coordinate);
        for (const art::Channel* const channel : {&bone.x, &bone.y})
            for (const auto& key : channel->keys)
                take(key.value);
    }
    return reach;
}

}
