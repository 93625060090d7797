#pragma once

#include "core/scene/scene_view.hpp"
#include "host/player/received_drawing.hpp"

#include <cstdint>

namespace kfast::fit {

/// How drawings go up and down between top and bottom.
enum class Bustle : std::uint8_t {
    waves, ///< one for every eight points, as high as chance has it: a lively plot
    noise, ///< at every point: hardly anything is harder to draw
};

/// What may come to the input `number` of the scene, a drawing: all the points that it takes, in as many
/// strokes, from the left to the right of its usual drawing, or of the canvas where that has no extent.
/// Another one for each `frame`, always the same.
ReceivedDrawing busy_drawing(const SceneView& scene, std::uint32_t number, Bustle bustle, int frame);

}
