#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <optional>
#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view object_name = "object";

/// Nothing when the node is no usable object; what is wrong is reported.
std::optional<Item> read_object(const kdl::Node& node, SceneContext& context);

NodeSchema object_schema();

}
