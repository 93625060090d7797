#pragma once

#include "core/scene_view.hpp"

#include <string_view>
#include <vector>

namespace kfast {

/// Of all inputs of a scene that are of this type, in its order. They live as long as the scene's bytes.
std::vector<std::string_view> input_names(const SceneView& scene, InputType type);

}
