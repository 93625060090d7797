#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/skeleton_table.hpp"
#include "host/scene/skeleton/bone_reader.hpp"

#include <vector>

namespace kfast::scene {

/// Puts bones into level order, each into the frame of its parent. Bones that hang on themselves, and with
/// them all that hang on these, are reported and left out, as is what the format cannot hold; then
/// `skeleton` is no longer good.
void set_up_bones(const std::vector<WrittenBone>& written, Skeleton& skeleton, SceneContext& context);

}
