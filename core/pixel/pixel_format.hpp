#pragma once

#include "core/math/point.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kfast {

// clang-format off
/// The pixel formats, a row each: the name, the bits of a pixel, and how pixels are stored.
#define KFAST_PIXEL_FORMATS(ROW)                                                                                     \
    ROW(rgb565, 16)        /* 2 bytes a pixel, little-endian, red in the highest 5 bits */                           \
    ROW(rgb565_be, 16)     /* as rgb565 with the high byte first, as panels on an 8-bit bus take it */               \
    ROW(rgb444, 12)        /* 2 pixels in 3 bytes: red, green, blue in 4 bits each, the first in the high nibble */  \
    ROW(rgb666, 24)        /* 3 bytes a pixel: red, green, blue, each in the high 6 bits; the low 2 are 0 */         \
    ROW(grey4, 4)          /* 2 pixels a byte, the left one in the high nibble; 15 is white */                       \
    ROW(mono1, 1)          /* 8 pixels a byte, the leftmost in the highest bit; 1 is lit, from half brightness on */ \
    ROW(mono1_dithered, 1) /* as mono1, but as many pixels are lit as the brightness says */
// clang-format on

/// How the pixels of a row are stored in memory. Every row starts on a byte.
enum class PixelFormat : std::uint8_t {
#define KFAST_ENUMERATOR(name, bits) name,
    KFAST_PIXEL_FORMATS(KFAST_ENUMERATOR)
#undef KFAST_ENUMERATOR
};

inline constexpr std::array pixel_formats{
#define KFAST_FORMAT(name, bits) PixelFormat::name,
    KFAST_PIXEL_FORMATS(KFAST_FORMAT)
#undef KFAST_FORMAT
};

constexpr std::string_view name_of(PixelFormat format)
{
    switch (format) {
#define KFAST_NAME(name, bits)                                                                               \
    case PixelFormat::name:                                                                                  \
        return #name;
        KFAST_PIXEL_FORMATS(KFAST_NAME)
#undef KFAST_NAME
    }
    return {};
}

constexpr int bits_per_pixel(PixelFormat format)
{
    constexpr std::array bits_of_formats{
#define KFAST_BITS(name, bits) bits,
        KFAST_PIXEL_FORMATS(KFAST_BITS)
#undef KFAST_BITS
    };
    return bits_of_formats[static_cast<std::size_t>(format)];
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
#define KFAST_USE(name, bits)                                                                                \
    case PixelFormat::name:                                                                                  \
        return use.template operator()<PixelFormat::name>();
        KFAST_PIXEL_FORMATS(KFAST_USE)
#undef KFAST_USE
    }
}

}
