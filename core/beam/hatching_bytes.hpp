#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>

namespace kfast {

/// Memory for the hatchings of a scene, besides that for outlines, a multiple of 4: for two crossings on each
/// line of every hatched object, as if each were as large as the canvas. What is larger, or has more holes,
/// has the room that others leave.
std::size_t hatching_bytes(const SceneView& scene);

}
