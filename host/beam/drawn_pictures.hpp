#pragma once

#include "core/scene/scene_view.hpp"
#include "host/beam/beam_screen.hpp"
#include "host/beam/beam_source.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// What the beam drew up to `moment`, for at least `memory` points: the oldest picture first.
///
/// At `moment` it is as far in its picture as if it had drawn this one since the scene began. Before that it
/// drew others, each as the scene was when the next one began, and so often that 60 pictures a second were
/// enough: whole tours. Before the scene's beginning comes what its loop says.
std::vector<DrawnPicture> drawn_pictures(BeamSource& source, const SceneView& scene, Time moment,
                                         std::int64_t memory);

/// How many points the pictures of a scene have on the average.
std::int64_t default_points(const SceneView& scene, const BeamProfile& profile);

}
