#pragma once

#include "core/time/time.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/pose_reader.hpp"

#include <vector>

namespace kfast::scene {

/// A turn that a pose gives itself.
struct GivenTurn {
    std::size_t bone = 0;
    Time time;
    SourceSpan place;
};

/// Each bone of each pose gets a key of all of its quantities. Returns the turns that are written for times;
/// of the other keys, the angle is that as set up. Reports what the format cannot hold.
std::vector<GivenTurn> add_pose_keys(const std::vector<Pose>& poses, std::vector<Bone>& bones,
                                     SceneContext& context);

/// After the last key: removes the keys of quantities that stay as set up, and laws without a way.
void tidy_keys(std::vector<Bone>& bones);

}
