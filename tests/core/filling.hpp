#pragma once

#include "core/pixel/pixel_format.hpp"

#include <cstddef>
#include <vector>

namespace kfast::test {

/// A picture whose rows have 0 in the bits behind their last pixel, where anything may be.
inline std::vector<std::byte> without_filling(PixelFormat format, Size size, std::vector<std::byte> picture)
{
    const std::size_t stride = row_bytes(format, size.width);
    const int filling = 8 * static_cast<int>(stride) - size.width * bits_per_pixel(format);
    for (std::size_t end = stride; end <= picture.size(); end += stride)
        picture[end - 1] &= static_cast<std::byte>((0xFF << filling) & 0xFF);
    return picture;
}

}
