#pragma once

#include "host/geometry/wire.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_schema.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The nodes that draw something with a depth: wire, mesh, cuboid.
std::span<const std::string_view> wire_names();
bool is_wire(std::string_view name);

/// The wires of `node`, for which is_wire() holds; none when it is wrong, which is reported. Those of a
/// cuboid may be out of range.
std::vector<Wire> read_wires(const kdl::Node& node, SceneContext& context);

std::vector<NodeSchema> wire_words();

}
