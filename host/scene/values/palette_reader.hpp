#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_schema.hpp"

namespace kfast::scene {

/// Declares the names inside the node in `context.palette`.
void read_palette(const kdl::Node& node, SceneContext& context);

std::vector<NodeSchema> palette_words();

}
