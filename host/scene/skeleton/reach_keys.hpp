#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/pose_keys.hpp"
#include "host/scene/skeleton/reach_reader.hpp"

#include <vector>

namespace kfast::scene {

/// Rotates the bones of each reach: angle keys, as dense as keeps the tip within 1/16 px of its target,
/// replace those of poses between the reach's begin and its end. `turns` are what poses may not set there.
/// Reports it, and warns of targets that are out of reach.
void add_reach_keys(std::vector<Reach> reaches, const std::vector<GivenTurn>& turns, std::vector<Bone>& bones,
                    SceneContext& context);

}
