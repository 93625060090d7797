#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <optional>

namespace kfast::scene {

/// Whether `node` is a text whose words, or whose number, come from an input.
bool is_label(const kdl::Node& node);

/// Reports a label where only shapes are allowed.
void report_label_among_shapes(const kdl::Node& node, SceneContext& context);

/// Reads `node`, which is a label. Reports what is wrong and then returns nothing.
std::optional<Label> read_label(const kdl::Node& node, SceneContext& context);

NodeSchema label_schema();

}
