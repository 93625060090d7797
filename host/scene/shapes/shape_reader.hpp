#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The nodes that draw something: path, circle …
std::span<const std::string_view> shape_names();
bool is_shape(std::string_view name);

/// The outlines of `node`, for which is_shape() holds; none if it is invalid, which is reported. Only paths
/// and texts use `points_left`, and only paths are sure to be in_range().
std::vector<Outline> read_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context);

std::vector<NodeSchema> shape_schema();

/// As read_shape(), for the nodes star and regular, whose form has been checked.
std::vector<Outline> read_star(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_regular(const kdl::Node& node, std::size_t points_left, SceneContext& context);

std::vector<PropertySchema> star_schema();
std::vector<PropertySchema> regular_schema();

/// As read_shape(), for the nodes arc and pie, whose form has been checked.
std::vector<Outline> read_arc(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_pie(const kdl::Node& node, std::size_t points_left, SceneContext& context);

/// The properties of arcs of circles, and of ellipses.
std::vector<std::vector<PropertySchema>> arc_schema();
std::vector<PropertySchema> pie_schema();

}
