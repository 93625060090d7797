#pragma once

#include "core/scene/scene_view.hpp"

#include <string_view>
#include <vector>

namespace kfast {

/// Of all clips that a scene has, in its order. They live as long as the scene's bytes.
std::vector<std::string_view> clip_names(const SceneView& scene);

}
