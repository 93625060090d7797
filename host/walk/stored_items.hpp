#pragma once

#include "core/scene/scene_view.hpp"
#include "host/walk/every_item.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>

namespace kfast {

/// An item that a scene stores, apart from where it is used.
struct StoredItem {
    std::size_t number = 0; ///< its place in SceneFile::item_names
    std::string name;       ///< its own; "object 3" for a leaf without one, else empty
};

/// All of them, by ItemView::place. `names` are those of the items in the order in which the scene stores
/// them, or none.
inline std::map<const std::byte*, StoredItem> stored_items(const SceneView& scene,
                                                           std::span<const std::string> names)
{
    std::map<const std::byte*, StoredItem> items;
    std::size_t leaves = 0;
    every_item(scene, [&](const ItemView& item) {
        const std::size_t number = items.size();
        StoredItem& stored = items[item.place];
        stored = {number, number < names.size() ? names[number] : ""};
        leaves += item.is_leaf() ? 1 : 0;
        if (item.is_leaf() && stored.name.empty())
            stored.name = "object " + std::to_string(leaves);
    });
    return items;
}

}
