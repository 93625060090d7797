#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the node text, whose form has been checked but for its words.
std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context);

/// The schema of texts that lie at a place, and of those along a path.
NodeSchema text_schema();
NodeSchema path_text_schema();

}
