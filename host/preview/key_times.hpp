#pragma once

#include "core/scene_view.hpp"

#include <vector>

namespace kfast {

/// When any object of the scene has a key: in order, each time once.
std::vector<Time> key_times(const SceneView& scene);

}
