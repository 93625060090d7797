#pragma once

#include "core/scene/scene_view.hpp"

#include <vector>

namespace kfast {

/// The times on `driver` at which any drawing, track or bone of the scene has a key, in groups and symbols
/// too: in order, each once.
std::vector<Time> key_times(const SceneView& scene, Driver driver = {});
/// The times at which the scene comes to any of its keys: those on its own time, and of those on clocks the
/// first ones. In order, each once, to the scene's end.
std::vector<Time> shown_key_times(const SceneView& scene);
/// The same as key_times() for `item` itself, and for the bones or backbones that deform it; without what is
/// in it.
std::vector<Time> key_times(const SceneView& scene, const ItemView& item, Driver driver = {});
/// The same only for the bones that deform `item`, an object with a skin.
std::vector<Time> bone_key_times(const SceneView& scene, const ItemView& item, Driver driver = {});

}
