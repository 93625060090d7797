#pragma once

#include "core/size.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast {

/// How the pixels of a row lie in memory. Every row starts on a byte.
enum class PixelFormat : std::uint8_t {
    rgb565, ///< 2 bytes a pixel, little-endian, red in the highest 5 bits
    grey4,  ///< 2 pixels a byte, the left one in the high nibble; 15 is white
    mono1,  ///< 8 pixels a byte, the leftmost in the highest bit; 1 is lit
};

constexpr int bits_per_pixel(PixelFormat format)
{
    switch (format) {
    case PixelFormat::rgb565:
        return 16;
    case PixelFormat::grey4:
        return 4;
    case PixelFormat::mono1:
        return 1;
    }
    return 0;
}

/// Bytes of one row of `width` pixels.
constexpr std::size_t row_bytes(PixelFormat format, int width)
{
    return static_cast<std::size_t>((width * bits_per_pixel(format) + 7) / 8);
}

}
