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

/// The outlines of `node`, for which is_shape() holds; none when it is wrong, which is reported. Only
/// paths and texts look at `points_left`, and only paths are sure to be in_range().
std::vector<Outline> read_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context);

std::vector<NodeSchema> shape_words();

}
