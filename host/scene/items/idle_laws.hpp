#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"

#include <span>

namespace kfast::scene {

/// Warns of each law and match that has no way to govern: no later key sets what its key sets. `keys` are
/// those of one item.
void warn_of_idle_laws(std::span<const ItemKey> keys, SceneContext& context);

}
