#pragma once

#include "host/geometry/wire.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// Each function reports what is wrong and then returns nothing.
namespace kfast::scene {

/// All values of `node` as triples, of which there must be at least one.
std::optional<std::vector<Vec3>> read_space_spots(const kdl::Node& node, SceneContext& context);

/// Reads the content of the node `mesh`.
std::optional<Mesh> read_mesh(const kdl::Node& node, SceneContext& context);

std::vector<std::string_view> names_inside_mesh();
/// The schema of these.
std::vector<NodeSchema> mesh_schema();

/// The nodes that draw something with a depth: wire, mesh, cuboid.
std::span<const std::string_view> wire_names();
bool is_wire(std::string_view name);

/// The wires of `node`, for which is_wire() holds; none if it is invalid, which is reported. Those of a
/// cuboid may be out of range.
std::vector<Wire> read_wires(const kdl::Node& node, SceneContext& context);

std::vector<NodeSchema> wire_schema();

}
