#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The nodes that are items: object, group and use.
std::span<const std::string_view> item_names();
bool is_item(std::string_view name);

/// Adds the item `node`, for which is_item() holds; reports what is wrong. `depth` groups and uses are around
/// it, not counting those around a use of its symbol.
void read_item(const kdl::Node& node, int depth, std::vector<Item>& items, SceneContext& context);

/// `items` are all in one list.
void refuse_crowded_order(std::span<const Item> items, SceneContext& context);

inline constexpr std::string_view group_name = "group";

/// Nothing when the node is no usable group; what is wrong is reported. `depth` groups and uses are around
/// it.
std::optional<Item> read_group(const kdl::Node& node, int depth, SceneContext& context);

NodeSchema group_schema();

}
