#pragma once

#include "core/scene/check/read_allowance.hpp"
#include "core/scene/scene_view.hpp"

namespace kfast {

/// Whether nothing is wrong with the scene's skeletons of bones; `laws` pairs of laws are stored.
bool bones_are_sound(const SceneView& scene, std::uint32_t laws, ReadAllowance& allowance);

}
