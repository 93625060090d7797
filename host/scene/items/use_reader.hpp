#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

#include <optional>

namespace kfast::scene {

/// A symbol of items, used as an item: its Use has the number of the symbol's entry in `context.symbols`.
/// Nothing when it cannot be used; what is wrong is reported. `depth` groups and uses lie around it.
std::optional<Item> read_use(const kdl::Node& node, int depth, SceneContext& context);

}
