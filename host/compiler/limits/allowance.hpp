#pragma once

#include "core/scene/scene_view.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace kfast {

/// Checks how many strokes are matched by length, which takes long. Too many are an error at the item that
/// has most of them.
void check_matching(const scene::Scene& scene, Diagnostics& diagnostics);

/// Checks what the format limits of a whole scene: items, tracks and steps of painting. Too much of any is an
/// error at the item that has most of it.
void check_allowances(const scene::Scene& scene, Diagnostics& diagnostics);

/// `file` is the scene compiled. If a player refuses it, because a picture would take too long, or checking
/// it would, that is an error at the item that takes most.
std::optional<SceneView> playable(std::span<const std::byte> file, const scene::Scene& scene,
                                  Diagnostics& diagnostics);

}
