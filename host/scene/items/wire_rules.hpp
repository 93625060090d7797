#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/drawing_content.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast::scene {

/// Whether any of the drawings has depths.
bool is_wire_frame(const std::vector<Key>& keys);

/// Reports drawings without depths among others that have them.
void refuse_mixed_depths(const std::vector<Key>& keys, SceneContext& context);

/// Reports what an object that is a wire frame cannot have: a fill, what carries it, matching by length.
void refuse_beside_wires(const kdl::Node& object, const DrawingContent& content, const std::vector<Key>& keys,
                         SceneContext& context);

}
