#pragma once

#include "core/time/time.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/pose_reader.hpp"

#include <vector>

namespace kfast::scene {

/// A rotation that a pose sets explicitly.
struct GivenTurn {
    std::size_t bone = 0;
    Time time;
    SourceSpan place;
};

/// Each bone of each pose gets a key of all of its quantities. Returns the rotations that are written for
/// times; the other keys have the angle as set up. Reports what the format cannot hold.
std::vector<GivenTurn> add_pose_keys(const std::vector<Pose>& poses, std::vector<Bone>& bones,
                                     SceneContext& context);

/// After the last key: removes the keys of quantities that stay as set up, and laws that govern nothing.
void tidy_keys(std::vector<Bone>& bones);

}
