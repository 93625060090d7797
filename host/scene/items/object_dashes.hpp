#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"

#include <vector>

namespace kfast::scene {

/// Repeats the lengths of dashes that an object and its keys give until all of them have as many, so that
/// each tweens. Reports where they do not fit, and where the first key has none.
void make_dashes_alike(const kdl::Node& object, ItemValues& values, std::vector<ItemKey>& keys,
                       SceneContext& context);

/// Adds to the tracks of an object that is dashed how many dashes it has at most. Reports if there are more
/// than a player draws. `place` is that of the object.
void add_max_dashes(std::vector<Track>& tracks, const Object& object, SourceSpan place,
                    SceneContext& context);

}
