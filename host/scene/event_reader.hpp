#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/reading.hpp"

#include <optional>

namespace kfast::scene {

/// Nothing when the node gives no usable event; what is wrong is reported. `scene` has its length and loop.
std::optional<Event> read_event(const kdl::Node& node, const Scene& scene, Reading& reading);

NodeWords event_words();

}
