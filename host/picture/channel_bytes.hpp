#pragma once

#include "host/picture/picture.hpp"

#include <cstddef>
#include <vector>

namespace kfast {

/// Red, green and blue of one pixel after the other.
inline std::vector<std::byte> channel_bytes(const Picture& picture)
{
    std::vector<std::byte> bytes;
    bytes.reserve(3 * picture.pixels.size());
    for (const Colour pixel : picture.pixels)
        bytes.insert(bytes.end(), {std::byte{pixel.red}, std::byte{pixel.green}, std::byte{pixel.blue}});
    return bytes;
}

}
