#pragma once

#include "core/scene/scene_view.hpp"

namespace kfast {

/// Whether the inputs of the scene, which has its sections, are what the format allows, but for the drawings
/// that they refer to.
bool inputs_are_sound(const SceneView& scene);

}
