#pragma once

#include "core/scene/scene_view.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast::test {

/// Bones as read are those that were written.
void compare_skeletons(const SceneView& view, const std::vector<scene::Bones>& skeletons);

}
