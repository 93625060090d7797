#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast {

/// Of all inputs of a scene that are of this type, in its order. They live as long as the scene's bytes.
std::vector<std::string_view> input_names(const SceneView& scene, InputType type);

/// In NAME=WHAT, where the sign between them stands; npos if there is none. Names may have one as well, and
/// so may what follows: behind the longest name of an input that fits, else the last one.
std::size_t end_of_input_name(std::string_view text, const SceneView& scene);

}
