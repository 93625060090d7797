#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace kfast::scene {

/// The strokes of the data of an SVG path, in_range(). Nothing when it is wrong, which is reported.
std::optional<std::vector<Outline>> read_path_data(const kdl::Value& value, std::size_t points_left,
                                                   SceneContext& context);

/// As read_shape(), for the node path, whose form has been checked.
std::vector<Outline> read_path(const kdl::Node& node, std::size_t points_left, SceneContext& context);

}
