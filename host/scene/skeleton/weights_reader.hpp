#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/skeleton/binding.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The node of weights for some points; no bone has this name.
inline constexpr std::string_view points_name = "points";

inline constexpr std::string_view weights_name = "weights";

/// Which bones the points at `spots` follow, by the node `weights`; automatic if it is null. Those that are
/// not given one by one are of `bones` alone (indices, at least one). `place` is that of the object. Nothing
/// if that cannot be determined; what is wrong is reported.
std::optional<std::vector<Binding>> read_weights(const kdl::Node* weights, const Skeleton& skeleton,
                                                 const std::vector<std::size_t>& bones,
                                                 const std::vector<Vec2>& spots, SourceSpan place,
                                                 SceneContext& context);

/// The schema of weights, of those of single points, and of the bones in both.
std::vector<NodeSchema> weights_schema();

}
