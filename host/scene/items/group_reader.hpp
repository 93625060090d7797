#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_schema.hpp"

#include <optional>
#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view group_name = "group";

/// Nothing when the node gives no usable group; what is wrong is reported. `depth` groups and uses lie
/// around it.
std::optional<Item> read_group(const kdl::Node& node, int depth, SceneContext& context);

NodeSchema group_words();

}
