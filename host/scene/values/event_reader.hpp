#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_schema.hpp"

#include <optional>

namespace kfast::scene {

/// Nothing when the node gives no usable event; what is wrong is reported. `scene` has its length and loop.
std::optional<Event> read_event(const kdl::Node& node, const Scene& scene, SceneContext& context);

NodeSchema event_words();

}
