#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the nodes arc and pie, whose form has been checked.
std::vector<Outline> read_arc(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_pie(const kdl::Node& node, std::size_t points_left, SceneContext& context);

/// Of arcs of circles, and of ellipses.
std::vector<std::vector<PropertySchema>> arc_words();
std::vector<PropertySchema> pie_words();

}
