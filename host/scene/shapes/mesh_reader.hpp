#pragma once

#include "host/geometry/mesh.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_schema.hpp"

#include <optional>
#include <vector>

/// Each function reports what is wrong and then returns nothing.
namespace kfast::scene {

/// All values of `node`, by threes; there must be at least one.
std::optional<std::vector<Vec3>> read_space_spots(const kdl::Node& node, SceneContext& context);

/// What stands inside of the node `mesh`.
std::optional<Mesh> read_mesh(const kdl::Node& node, SceneContext& context);

std::vector<std::string_view> names_inside_mesh();
/// Of these.
std::vector<NodeSchema> mesh_words();

}
