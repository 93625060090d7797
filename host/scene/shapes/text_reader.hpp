#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace kfast::scene {

/// Whether `node` is a text whose words come from an input.
bool is_label(const kdl::Node& node);

/// Reports a label where only shapes are allowed.
void report_label_among_shapes(const kdl::Node& node, SceneContext& context);

/// Reads `node`, which is a label. Reports what is wrong and then returns nothing.
std::optional<Label> read_label(const kdl::Node& node, SceneContext& context);

NodeSchema label_schema();

/// As read_shape(), for the node text, whose form has been checked but for its words.
std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context);

NodeSchema text_schema();

}
