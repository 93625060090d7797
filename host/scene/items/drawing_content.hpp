#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/timed_quantity.hpp"

#include <vector>

namespace kfast::scene {

/// The content of an object, or of a symbol that is a drawing. The drawings are either in keys or directly
/// inside.
struct DrawingContent {
    std::vector<ItemKey> keys;
    std::vector<TimedQuantity> timed;    ///< of objects
    std::vector<const kdl::Node*> drawn; ///< directly inside: for these is_drawn() holds
    const kdl::Node* weights = nullptr;  ///< only of an object
    bool is_valid = true;                ///< all nodes were known, all keys have their time
};

/// The names of the nodes that these may hold. `holder` is not KeyHolder::group, here and below.
std::vector<std::string_view> names_in_drawing(KeyHolder holder);

DrawingContent read_drawing_content(const kdl::Node& node, KeyHolder holder, const KeyDriver& driver,
                                    SceneContext& context);

/// Whether any of the drawings has depths.
bool is_wire_frame(const std::vector<Key>& keys);

/// Reports drawings without depths among others that have them.
void refuse_mixed_depths(const std::vector<Key>& keys, SceneContext& context);

/// Reports what an object that is a wire frame cannot have: a fill, what deforms it, matching by length.
void refuse_beside_wires(const kdl::Node& object, const DrawingContent& content, const std::vector<Key>& keys,
                         SceneContext& context);

}
