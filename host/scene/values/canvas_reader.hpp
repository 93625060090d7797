#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

namespace kfast::scene {

/// Fills the canvas, frame rate and loop of `scene`, puts the background first into the palette and sets what
/// the nodes that follow need: the frame rate, and the length if the canvas sets one.
void read_canvas(const kdl::Node& node, Scene& scene, SceneContext& context);

NodeSchema canvas_schema();

/// Declares the names inside the node in `context.palette`.
void read_palette(const kdl::Node& node, SceneContext& context);

std::vector<NodeSchema> palette_schema();

}
