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

/// A node `track` of an item. Nothing when it cannot be said what it is a track of, which is reported like
/// everything else. `node` must live as long as the quantity.
std::optional<TimedQuantity> read_track(const kdl::Node& node, KeyHolder holder, SceneContext& context);

/// Of plain tracks, and of those along a path.
std::vector<NodeSchema> track_words();
/// What a track may move, and by which values.
std::vector<PropertySchema> quantity_words();

}
