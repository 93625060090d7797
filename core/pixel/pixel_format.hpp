#pragma once

#include "core/math/point.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// How the pixels of a row are stored in memory. Every row starts on a byte.
enum class PixelFormat : std::uint8_t {
    rgb565,         ///< 2 bytes a pixel, little-endian, red in the highest 5 bits
    rgb565_be,      ///< as rgb565 with the high byte first, as panels on an 8-bit bus take it
    rgb444,         ///< 2 pixels in 3 bytes: red, green, blue in 4 bits each, the first in the high nibble
    rgb666,         ///< 3 bytes a pixel: red, green, blue, each in the high 6 bits; the low 2 are 0
    grey4,          ///< 2 pixels a byte, the left one in the high nibble; 15 is white
    mono1,          ///< 8 pixels a byte, the leftmost in the highest bit; 1 is lit, from half brightness on
    mono1_dithered, ///< as mono1, but as many pixels are lit as the brightness says
};

inline constexpr std::array pixel_formats{
    PixelFormat::rgb565, PixelFormat::rgb565_be, PixelFormat::rgb444,         PixelFormat::rgb666,
    PixelFormat::grey4,  PixelFormat::mono1,     PixelFormat::mono1_dithered,
};

constexpr int bits_per_pixel(PixelFormat format)
{
    switch (format) {
    case PixelFormat::rgb565:
    case PixelFormat::rgb565_be:
        return 16;
    case PixelFormat::rgb444:
        return 12;
    case PixelFormat::rgb666:
        return 24;
    case PixelFormat::grey4:
        return 4;
    case PixelFormat::mono1:
    case PixelFormat::mono1_dithered:
        return 1;
    }
    return 0;
}

/// The fewest pixels that fill whole bytes: in columns that are a multiple of it a pixel begins on a byte.
constexpr int pixels_in_whole_bytes(PixelFormat format)
{
    int pixels = 1;
    while (bits_per_pixel(format) * pixels % 8 != 0)
        ++pixels;
    return pixels;
}

/// Bytes of one row of `width` pixels.
constexpr std::size_t row_bytes(PixelFormat format, int width)
{
    return static_cast<std::size_t>((width * bits_per_pixel(format) + 7) / 8);
}

/// Calls `use.template operator()<format>()`: from a format chosen at run time to code made for it.
template <class Use>
constexpr void with_format(PixelFormat format, Use&& use)
{
    switch (format) {
    case PixelFormat::rgb565:
        return use.template operator()<PixelFormat::rgb565>();
    case PixelFormat::rgb565_be:
        return use.template operator()<PixelFormat::rgb565_be>();
    case PixelFormat::rgb444:
        return use.template operator()<PixelFormat::rgb444>();
    case PixelFormat::rgb666:
        return use.template operator()<PixelFormat::rgb666>();
    case PixelFormat::grey4:
        return use.template operator()<PixelFormat::grey4>();
    case PixelFormat::mono1:
        return use.template operator()<PixelFormat::mono1>();
    case PixelFormat::mono1_dithered:
        return use.template operator()<PixelFormat::mono1_dithered>();
    }
}

}
