#pragma once

#include "core/scene/scene_view.hpp"

#include <vector>

namespace kfast {

/// Where on `driver` any drawing, track or bone of the scene has a key, in groups and symbols too: in order,
/// each moment once.
std::vector<Time> key_times(const SceneView& scene, Driver driver = {});
/// Likewise those of `item` itself, and of the bones or backbones that carry it; not of what lies in it.
std::vector<Time> key_times(const SceneView& scene, const ItemView& item, Driver driver = {});
/// Of the bones that carry `item`, an object with a skin, alone.
std::vector<Time> bone_key_times(const SceneView& scene, const ItemView& item, Driver driver = {});

}
