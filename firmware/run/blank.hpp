#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace kfast {

/// Whether nothing has ever been written to the place of a scene.
inline bool is_blank(std::span<const std::byte> place)
{
    if (place.size() < 4)
        return place.empty();
    const auto beginning = place.first(4);
    return std::ranges::all_of(beginning, [&](std::byte byte) { return byte == place[0]; }) &&
           (place[0] == std::byte{0xFF} || place[0] == std::byte{0});
}

}
