#pragma once

#include "core/bytes/expects.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/pixel/pixel_format.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace kfast {

// Runs of pixels of the same colour are stored in words, as far as they are aligned in memory.
using Halfword [[gnu::may_alias]] = std::uint16_t;
using Word [[gnu::may_alias]] = std::uint32_t;

static_assert(std::endian::native == std::endian::little, "pixels are stored in words");

inline std::uintptr_t beyond_word(const std::byte* at) { return reinterpret_cast<std::uintptr_t>(at) % 4; }

/// Stores `halfword` `count` times. `at` is aligned to 2.
inline void fill_halfwords(std::byte* at, int count, std::uint32_t halfword)
{
    expects(reinterpret_cast<std::uintptr_t>(at) % 2 == 0);
    auto* single = reinterpret_cast<Halfword*>(at);
    if (count > 0 && beyond_word(at) != 0) {
        *single++ = static_cast<std::uint16_t>(halfword);
        --count;
    }
    const std::uint32_t both = halfword << 16 | halfword;
    auto* word = reinterpret_cast<Word*>(single);
    for (; count >= 8; count -= 8, word += 4) {
        word[0] = both;
        word[1] = both;
        word[2] = both;
        word[3] = both;
    }
    for (; count >= 2; count -= 2)
        *word++ = both;
    if (count > 0)
        *reinterpret_cast<Halfword*>(word) = static_cast<std::uint16_t>(halfword);
}

inline void store_triple(std::byte* at, std::uint32_t triple)
{
    at[0] = static_cast<std::byte>(triple & 255);
    at[1] = static_cast<std::byte>(triple >> 8 & 255);
    at[2] = static_cast<std::byte>(triple >> 16);
}

/// Stores three bytes, the one in the lowest bits first, `count` times.
inline void fill_triples(std::byte* at, int count, std::uint32_t triple)
{
    for (; count > 0 && beyond_word(at) != 0; --count, at += 3)
        store_triple(at, triple);
    for (; count >= 4; count -= 4, at += 12) {
        auto* word = reinterpret_cast<Word*>(at);
        word[0] = triple << 24 | triple;
        word[1] = triple << 16 | triple >> 8;
        word[2] = triple << 8 | triple >> 16;
    }
    for (; count > 0; --count, at += 3)
        store_triple(at, triple);
}

/// Takes the bits `mask` of `at` from `byte`.
inline void merge(std::byte& at, std::uint32_t byte, std::uint32_t mask)
{
    at = static_cast<std::byte>((std::to_integer<std::uint32_t>(at) & ~mask) | (byte & mask));
}

/// Repeats `byte` in the bits `begin` … `end` - 1 of the row at `first`, counted from the highest of its
/// first byte; the others stay.
inline void fill_bits(std::byte* first, int begin, int end, std::uint32_t byte)
{
    if (begin >= end)
        return;
    const std::uint32_t from_begin = 0xFFU >> (begin & 7);
    const std::uint32_t until_end = 0xFF00U >> (end & 7);
    std::byte* at = first + (begin >> 3);
    std::byte* const last = first + (end >> 3);
    if (at == last)
        return merge(*at, byte, from_begin & until_end);
    merge(*at, byte, from_begin);
    std::fill(at + 1, last, static_cast<std::byte>(byte));
    if ((end & 7) != 0)
        merge(*last, byte, until_end & 0xFF);
}

/// How one format stores and mixes pixels: ink() makes a pixel of a colour, load() and store() reach the
/// pixel `index` of the row at `first`, fill() stores one several times, mixed() blends one over another.
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
