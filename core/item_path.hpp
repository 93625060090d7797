#pragma once

#include "core/item_view.hpp"
#include "core/scene_view.hpp"

#include <cstdint>

namespace kfast {

/// Tells an item apart wherever symbols are used; `outer` is the path of the group or use that it lies in, 0
/// of the outermost ones. Items that lie beside each other begin at different bytes, and a path leads through
/// eight of them at most.
inline std::uint32_t path_to(const ItemView& item, std::uint32_t outer, const SceneView& scene)
{
    const auto place = static_cast<std::uint32_t>(item.place - scene.drawings().data());
    return (outer ^ place) * 0x9E37'79B1U + (outer >> 15);
}

}
