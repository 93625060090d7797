#pragma once

#include "core/scene/scene_view.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast::test {

/// What a player is told of the inputs is what was written.
void compare_inputs(const SceneView& view, const std::vector<scene::Input>& inputs);

}
