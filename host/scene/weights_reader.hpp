#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/binding.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/outline.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/skeleton_table.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The node of weights for some points; no bone has this name.
inline constexpr std::string_view points_name = "points";

inline constexpr std::string_view weights_name = "weights";

/// What bones the points at `spots` follow, by the node `weights`; automatically if it is null. `place` is
/// that of the object. Nothing if that cannot be said; what is wrong is reported.
std::optional<std::vector<Binding>> read_weights(const kdl::Node* weights, const Skeleton& skeleton,
                                                 const std::vector<Spot>& spots, Place place,
                                                 Reading& reading);

/// Of weights, of those of single points, and of the bones in both.
std::vector<NodeWords> weights_words();

}
