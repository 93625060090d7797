#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the nodes star and regular, whose form has been checked.
std::vector<Outline> read_star(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_regular(const kdl::Node& node, std::size_t points_left, SceneContext& context);

std::vector<PropertySchema> star_words();
std::vector<PropertySchema> regular_words();

}
