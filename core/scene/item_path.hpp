#pragma once

#include <cstdint>

namespace kfast {

/// Tells an item, which is stored at `place` (SceneView::place_of), apart wherever symbols are used; `outer`
/// is the path of the group or use that it lies in, 0 of the outermost ones. Items that lie beside each other
/// begin at different bytes, and a path leads through eight of them at most.
constexpr std::uint32_t path_to(std::uint32_t place, std::uint32_t outer)
{
    return (outer ^ place) * 0x9E37'79B1U + (outer >> 15);
}

}
