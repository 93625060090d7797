#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_schema.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the nodes polygon, line and curve, whose form has been checked.
std::vector<Outline> read_polygon(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_line(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_curve(const kdl::Node& node, std::size_t points_left, SceneContext& context);

std::vector<PropertySchema> curve_words();

}
