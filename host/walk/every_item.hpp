#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace kfast {

/// Calls visit(item) for `items` and all inside of their groups; uses of symbols are not followed.
template <class Visit>
void every_item(ItemCursor items, Visit visit)
{
    while (!items.at_end()) {
        const ItemView item = items.next();
        visit(item);
        if (item.kind == ItemKind::group)
            every_item(ItemCursor{item.items}, visit);
    }
}

/// Calls visit(item) for every item that the scene stores, those of a symbol once.
template <class Visit>
void every_item(const SceneView& scene, Visit visit)
{
    for (std::uint32_t symbol = 0; symbol < scene.symbol_count(); ++symbol)
        every_item(scene.symbol(symbol), visit);
    every_item(scene.items(), visit);
}

/// The objects that the scene stores, live ones too, those of a symbol counted once.
inline std::size_t object_count(const SceneView& scene)
{
    std::size_t count = 0;
    every_item(scene, [&count](const ItemView& item) { count += item.is_leaf() ? 1 : 0; });
    return count;
}

/// An item that a scene stores, apart from where it is used.
struct StoredItem {
    std::size_t number = 0; ///< its index in SceneFile::item_names
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

/// The skeleton with this number, by which the objects that it deforms refer to it.
inline SkeletonView skeleton_of(const SceneView& scene, std::uint32_t number)
{
    SkeletonCursor skeletons = scene.skeletons();
    for (; number > 0; --number)
        skeletons.skip();
    return skeletons.next();
}

}
