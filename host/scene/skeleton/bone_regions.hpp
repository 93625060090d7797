#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/binding.hpp"
#include "host/scene/skeleton/bone_frames.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// The regions of influence of some of a skeleton's bones, as set up: all that is nearer to a bone than its
/// radius.
class BoneRegions {
public:
    /// `bones` are indices of the skeleton's bones, at least one.
    BoneRegions(const Skeleton& skeleton, const std::vector<std::size_t>& bones);

    /// The bones in whose regions `spot` is. A weight is 1 on the bone and falls smoothly to 0 at the
    /// border.
    std::vector<WeightedBone> around(Vec2 spot) const;
    std::size_t nearest(Vec2 spot) const;

private:
    struct Region {
        std::size_t bone;
        Vec2 from;
        Vec2 to;
        double radius;
    };
    static double distance_to(const Region& region, Vec2 spot);

    std::vector<Region> regions_;
};

/// Warns of an object at `place` whose points were bound by the regions of these bones, if some follow two
/// bones alike that overlap as set up and then move apart: they follow neither. `bindings` are those of its
/// points as `weights` counts them.
void warn_of_overlapping_bones(const std::vector<Bone>& bones, const std::vector<Binding>& bindings,
                               SourceSpan place, SceneContext& context);

}
