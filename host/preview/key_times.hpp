#pragma once

#include "core/scene_view.hpp"

#include <vector>

namespace kfast {

/// When any drawing or track of the scene has a key, in groups and symbols too: in order, each time once.
std::vector<Time> key_times(const SceneView& scene);

}
