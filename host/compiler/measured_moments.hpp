#pragma once

#include "core/scene_view.hpp"
#include "core/time.hpp"

#include <vector>

namespace kfast {

/// At which the outlines of a scene are measured, in their order: four moments of each frame, or 4000 in all
/// if the scene is long, and wherever it may change at once: the time of every key of drawings, backbones and
/// tracks, and the tick before.
std::vector<Time> measured_moments(const SceneView& scene);

}
