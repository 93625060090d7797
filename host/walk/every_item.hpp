#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>

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

}
