#pragma once

#include "core/pixel/pixel_format.hpp"
#include "core/pixel/pixel_row.hpp"
#include "core/raster/cells.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kfast::raster {

/// How the cells of a row become pixels of a panel. For a format that has `is_direct`, pixels are cells.
template <PixelFormat format>
struct Packing;

template <>
struct Packing<PixelFormat::rgb565> {
    using Cells = Rgb565Cells;
    static constexpr bool is_direct = true;
    static void finish(std::uint16_t*, std::size_t) {}
};

template <>
struct Packing<PixelFormat::rgb565_be> {
    using Cells = Rgb565Cells;
    static constexpr bool is_direct = true;
    /// Swaps the bytes of `count` pixels.
    static void finish(std::uint16_t* pixels, std::size_t count)
    {
        for (std::uint16_t* const end = pixels + count; pixels != end; ++pixels)
            *pixels = static_cast<std::uint16_t>(*pixels << 8 | *pixels >> 8);
    }
};

/// 0 … 255 in `bits` bits, rounded to nearest.
template <int bits>
constexpr std::uint32_t narrowed(std::uint32_t channel)
{
    return narrow_channel(channel & 255, (1U << bits) - 1);
}

/// The formats below pack `count` cells, from column x of row y of the panel on. x is a multiple of
/// pixels_in_whole_bytes(), and `count` is one, too, or the row ends with it.
template <>
struct Packing<PixelFormat::rgb444> {
    using Cells = Rgb888Cells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint32_t* cells, int count, std::byte* to, int, int)
    {
        for (; count > 0; count -= 2, cells += 2, to += 3) {
            const std::uint32_t left = pixel(cells[0]);
            const std::uint32_t right = count > 1 ? pixel(cells[1]) : 0;
            to[0] = static_cast<std::byte>(left >> 4);
            to[1] = static_cast<std::byte>(left << 4 | right >> 8);
            if (count > 1)
                to[2] = static_cast<std::byte>(right);
        }
    }

private:
    static constexpr std::uint32_t pixel(std::uint32_t cell)
    {
        return narrowed<4>(cell >> 16) << 8 | narrowed<4>(cell >> 8) << 4 | narrowed<4>(cell);
    }
};

template <>
struct Packing<PixelFormat::rgb666> {
    using Cells = Rgb888Cells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint32_t* cells, int count, std::byte* to, int, int)
    {
        for (; count > 0; --count, ++cells)
            for (int shift = 16; shift >= 0; shift -= 8)
                *to++ = static_cast<std::byte>(narrowed<6>(*cells >> shift) << 2);
    }
};

template <>
struct Packing<PixelFormat::grey4> {
    using Cells = GreyCells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint8_t* cells, int count, std::byte* to, int, int)
    {
        for (; count > 0; count -= 2, cells += 2)
            *to++ =
                static_cast<std::byte>(narrowed<4>(cells[0]) << 4 | (count > 1 ? narrowed<4>(cells[1]) : 0));
    }
};

/// One bit for each cell for which is_lit(brightness, x) holds, the leftmost in the highest.
template <class IsLit>
void pack_bits(const std::uint8_t* cells, int count, std::byte* to, IsLit is_lit)
{
    for (int x = 0; x < count; x += 8) {
        std::uint32_t bits = 0;
        for (int i = 0; i < 8; ++i)
            bits = bits << 1 | (x + i < count && is_lit(cells[x + i], x + i) ? 1U : 0U);
        *to++ = static_cast<std::byte>(bits);
    }
}

template <>
struct Packing<PixelFormat::mono1> {
    using Cells = GreyCells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint8_t* cells, int count, std::byte* to, int, int)
    {
        pack_bits(cells, count, to, [](std::uint32_t brightness, int) { return brightness >= 128; });
    }
};

template <>
struct Packing<PixelFormat::mono1_dithered> {
    using Cells = GreyCells;
    static constexpr bool is_direct = false;
    static void pack(const std::uint8_t* cells, int count, std::byte* to, int x, int y)
    {
        pack_bits(cells, count, to,
                  [=](std::uint32_t brightness, int i) { return dither.is_lit(brightness, x + i, y); });
    }
};

}
