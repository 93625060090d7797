#pragma once

#include "core/pixel/channel.hpp"
#include "core/pixel/colour.hpp"
#include "core/pixel/pixel_format.hpp"
#include "core/pixel/wide_fill.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast {

/// How one format stores and mixes pixels: ink() makes a pixel of a colour, load() and store() reach the
/// pixel `index` of the row at `first`, fill() stores one several times, mixed() lays one over another.
template <PixelFormat format>
struct PixelCoding;

/// Three channels in one number, blue in the lowest bits. Red and blue are mixed at once, 16 bits apart.
template <int red_bits, int green_bits, int blue_bits>
struct RgbPixel {
    static constexpr std::uint32_t ink(Colour colour)
    {
        return narrow_channel(colour.red, (1U << red_bits) - 1) << red_at |
               narrow_channel(colour.green, green_max) << blue_bits | narrow_channel(colour.blue, blue_max);
    }

    static constexpr std::uint32_t mixed(std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
    {
        const std::uint32_t sides = blend_two_channels(red_and_blue(under), red_and_blue(over), coverage);
        return sides >> 16 << red_at | blend_channel(green(under), green(over), coverage) << blue_bits |
               (sides & blue_max);
    }

private:
    static constexpr int red_at = green_bits + blue_bits;
    static constexpr std::uint32_t green_max = (1U << green_bits) - 1;
    static constexpr std::uint32_t blue_max = (1U << blue_bits) - 1;

    static constexpr std::uint32_t red_and_blue(std::uint32_t pixel)
    {
        return pixel >> red_at << 16 | (pixel & blue_max);
    }
    static constexpr std::uint32_t green(std::uint32_t pixel) { return pixel >> blue_bits & green_max; }
};

/// Rows are aligned to 2.
template <>
struct PixelCoding<PixelFormat::rgb565> : RgbPixel<5, 6, 5> {
    static std::uint32_t load(const std::byte* first, int index)
    {
        return reinterpret_cast<const Halfword*>(first)[index];
    }
    static void store(std::byte* first, int index, std::uint32_t pixel)
    {
        reinterpret_cast<Halfword*>(first)[index] = static_cast<std::uint16_t>(pixel);
    }
    static void fill(std::byte* first, int index, int count, std::uint32_t pixel)
    {
        fill_halfwords(first + 2 * index, count, pixel);
    }
};

/// Rows are aligned to 2.
template <>
struct PixelCoding<PixelFormat::rgb565_be> : RgbPixel<5, 6, 5> {
    using Swapped = PixelCoding<PixelFormat::rgb565>;

    static std::uint32_t load(const std::byte* first, int index)
    {
        return swapped(Swapped::load(first, index));
    }
    static void store(std::byte* first, int index, std::uint32_t pixel)
    {
        Swapped::store(first, index, swapped(pixel));
    }
    static void fill(std::byte* first, int index, int count, std::uint32_t pixel)
    {
        Swapped::fill(first, index, count, swapped(pixel));
    }

private:
    static constexpr std::uint32_t swapped(std::uint32_t pixel) { return (pixel & 255) << 8 | pixel >> 8; }
};

template <>
struct PixelCoding<PixelFormat::rgb444> : RgbPixel<4, 4, 4> {
    static std::uint32_t load(const std::byte* first, int index)
    {
        const std::byte* at = first + (3 * index >> 1);
        const std::uint32_t both =
            std::to_integer<std::uint32_t>(at[0]) << 8 | std::to_integer<std::uint32_t>(at[1]);
        return is_left(index) ? both >> 4 : both & 0xFFF;
    }

    static void store(std::byte* first, int index, std::uint32_t pixel)
    {
        std::byte* at = first + (3 * index >> 1);
        const std::uint32_t both = is_left(index) ? pixel << 4 : pixel;
        merge(at[0], both >> 8, is_left(index) ? 0xFF : 0x0F);
        merge(at[1], both, is_left(index) ? 0xF0 : 0xFF);
    }

    static void fill(std::byte* first, int index, int count, std::uint32_t pixel)
    {
        if (!is_left(index) && count > 0) {
            store(first, index++, pixel);
            --count;
        }
        fill_triples(first + (3 * index >> 1), count >> 1, pair(pixel));
        if (count & 1)
            store(first, index + count - 1, pixel);
    }

private:
    static constexpr bool is_left(int index) { return (index & 1) == 0; }

    static constexpr std::uint32_t pair(std::uint32_t pixel)
    {
        return pixel >> 4 | ((pixel & 0xF) << 4 | pixel >> 8) << 8 | (pixel & 0xFF) << 16;
    }
};

template <>
struct PixelCoding<PixelFormat::rgb666> : RgbPixel<6, 6, 6> {
    static std::uint32_t load(const std::byte* first, int index)
    {
        const std::byte* at = first + 3 * index;
        return std::to_integer<std::uint32_t>(at[0]) >> 2 << 12 |
               std::to_integer<std::uint32_t>(at[1]) >> 2 << 6 | std::to_integer<std::uint32_t>(at[2]) >> 2;
    }
    static void store(std::byte* first, int index, std::uint32_t pixel)
    {
        store_triple(first + 3 * index, triple(pixel));
    }
    static void fill(std::byte* first, int index, int count, std::uint32_t pixel)
    {
        fill_triples(first + 3 * index, count, triple(pixel));
    }

private:
    static constexpr std::uint32_t triple(std::uint32_t pixel)
    {
        return pixel >> 12 << 2 | (pixel >> 6 & 63) << 10 | (pixel & 63) << 18;
    }
};

/// Formats with a single channel of `bits` bits, several pixels to a byte, the leftmost in the highest bits.
template <int bits>
struct BrightnessCoding {
    static constexpr std::uint32_t ink(Colour colour) { return narrow_channel(brightness(colour), max); }

    static constexpr std::uint32_t mixed(std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
    {
        return blend_channel(under, over, coverage);
    }

    static std::uint32_t load(const std::byte* first, int index)
    {
        return std::to_integer<std::uint32_t>(first[index * bits >> 3]) >> shift(index) & max;
    }
    static void store(std::byte* first, int index, std::uint32_t pixel)
    {
        merge(first[index * bits >> 3], pixel << shift(index), max << shift(index));
    }
    static void fill(std::byte* first, int index, int count, std::uint32_t pixel)
    {
        fill_bits(first, index * bits, (index + count) * bits, pixel * (255 / max));
    }

private:
    static constexpr std::uint32_t max = (1U << bits) - 1;
    static constexpr int shift(int index) { return 8 - bits - (index * bits & 7); }
};

template <>
struct PixelCoding<PixelFormat::grey4> : BrightnessCoding<4> {
};

template <>
struct PixelCoding<PixelFormat::mono1> : BrightnessCoding<1> {
};

}
