#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <span>
#include <vector>

namespace kfast::scene {

/// The skeletons of `keys`, which are those of one object, with the laws of their transitions; keys without
/// one give none. What is wrong is reported, and then left out.
std::vector<BackboneKey> read_skeletons(std::span<const ItemKey> keys, SceneContext& context);

NodeSchema skeleton_schema();

}
