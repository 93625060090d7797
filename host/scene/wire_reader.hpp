#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/wire.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The nodes that draw something with a depth: wire, mesh, cuboid.
std::span<const std::string_view> wire_names();
bool is_wire(std::string_view name);

/// The wires of `node`, for which is_wire() holds; none when it is wrong, which is reported. Those of a
/// cuboid may be out of range.
std::vector<Wire> read_wires(const kdl::Node& node, Reading& reading);

std::vector<NodeWords> wire_words();

}
