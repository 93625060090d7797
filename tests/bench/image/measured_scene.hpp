#pragma once

#include "tests/bench/bench_board.hpp"

namespace kfast::bench {

/// What the image has of the player.
extern const Features& linked_features;

/// Tells what a frame of the steady loop has cost.
void report_frame(const FrameCost& frame);

/// Plays the scene; reports every frame of the second turn. What it has cost to make the player.
Result<std::uint32_t> measure_scene(const SceneView& scene, const Workspace& workspace);
/// The same, but tells which instructions are run.
Result<std::uint32_t> profile_scene(const SceneView& scene, const Workspace& workspace);

}
