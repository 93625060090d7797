#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/timed_quantity.hpp"

#include <span>

namespace kfast::scene {

/// Reports each of `timed` that gives what the item itself (`values`), one of its keys or another track gives
/// as well, and a path beside a position.
void refuse_duplicate_quantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                                 std::span<const ItemKey> keys, SceneContext& context);

}
