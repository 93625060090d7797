#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/values/timed_quantity.hpp"
#include "host/schema/node_form.hpp"

#include <optional>
#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view track_name = "track";

/// Reads a node `track` of an item. Nothing when its quantity is unknown, which is reported like everything
/// else. `node` must live as long as the quantity.
std::optional<TimedQuantity> read_track(const kdl::Node& node, KeyHolder holder, SceneContext& context);

/// The schema of plain tracks, and of those along a path.
std::vector<NodeSchema> track_schema();
/// The quantities that a track may animate, and their values.
std::vector<PropertySchema> quantity_schema();

}
