#pragma once

#include "core/colour.hpp"
#include "core/pixel_format.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// A channel of 0 … 255 in a format whose largest value is `max`, rounded to nearest.
constexpr std::uint32_t narrow_channel(std::uint32_t value, std::uint32_t max)
{
    return (value * max + 127) / 255;
}

/// A channel of a pixel picture as 0 … 255, rounded to nearest.
constexpr std::uint32_t widen_channel(std::uint32_t value, std::uint32_t max)
{
    return (value * 255 + max / 2) / max;
}

/// `over` laid on `under` with a coverage of 0 … 255, rounded to nearest; all in the same format.
constexpr std::uint32_t blend_channel(std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
{
    return (under * (255 - coverage) + over * coverage + 127) / 255;
}

/// Brightness, 0 … 255: 0.30 red + 0.59 green + 0.11 blue in 1/256, rounded to nearest.
constexpr std::uint32_t brightness(Colour colour)
{
    return (77U * colour.red + 150U * colour.green + 29U * colour.blue + 128) >> 8;
}

/// Paints stretches of one row. `row` points at the row's first byte.
template <PixelFormat format>
struct PixelRow;

template <>
struct PixelRow<PixelFormat::rgb565> {
    std::byte* row;

    static constexpr std::uint32_t ink(Colour colour)
    {
        return narrow_channel(colour.red, 31) << 11 | narrow_channel(colour.green, 63) << 5 |
               narrow_channel(colour.blue, 31);
    }

    void fill(int x, int count, std::uint32_t ink)
    {
        for (std::byte* at = row + 2 * x; count > 0; --count, at += 2)
            store(at, ink);
    }

    void blend(int x, int count, std::uint32_t ink, std::uint32_t coverage)
    {
        for (std::byte* at = row + 2 * x; count > 0; --count, at += 2)
            store(at, mixed(load(at), ink, coverage));
    }

    /// Makes what was painted since `before` was kept of the row as transparent as `opacity` (0 … 255) says.
    void fade_from(const std::byte* before, int width, std::uint32_t opacity)
    {
        for (std::byte* at = row; width > 0; --width, at += 2, before += 2)
            store(at, mixed(load(before), load(at), opacity));
    }

private:
    static std::uint32_t load(const std::byte* at)
    {
        return std::to_integer<std::uint32_t>(at[0]) | std::to_integer<std::uint32_t>(at[1]) << 8;
    }

    static std::uint32_t mixed(std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
    {
        return blend_channel(under >> 11, over >> 11, coverage) << 11 |
               blend_channel(under >> 5 & 63, over >> 5 & 63, coverage) << 5 |
               blend_channel(under & 31, over & 31, coverage);
    }

    static void store(std::byte* at, std::uint32_t pixel)
    {
        at[0] = static_cast<std::byte>(pixel & 255);
        at[1] = static_cast<std::byte>(pixel >> 8);
    }
};

/// Formats with a single channel of `bits` bits, several pixels to a byte, the leftmost in the highest bits.
template <int bits>
struct BrightnessRow {
    std::byte* row;

    static constexpr std::uint32_t max = (1U << bits) - 1;
    static constexpr std::uint32_t ink(Colour colour) { return narrow_channel(brightness(colour), max); }

    void fill(int x, int count, std::uint32_t ink)
    {
        for (; count > 0 && x % pixels_per_byte != 0; --count)
            store(x++, ink);
        const int bytes = count / pixels_per_byte;
        std::fill_n(row + x / pixels_per_byte, bytes, static_cast<std::byte>(ink * (255 / max)));
        for (x += bytes * pixels_per_byte, count %= pixels_per_byte; count > 0; --count)
            store(x++, ink);
    }

    void blend(int x, int count, std::uint32_t ink, std::uint32_t coverage)
    {
        for (const int end = x + count; x < end; ++x)
            store(x, blend_channel(load(row, x), ink, coverage));
    }

    /// As in PixelRow<PixelFormat::rgb565>.
    void fade_from(const std::byte* before, int width, std::uint32_t opacity)
    {
        for (int x = 0; x < width; ++x)
            store(x, blend_channel(load(before, x), load(row, x), opacity));
    }

private:
    static constexpr int pixels_per_byte = 8 / bits;
    static constexpr int shift(int x) { return 8 - bits * (x % pixels_per_byte + 1); }

    static std::uint32_t load(const std::byte* from, int x)
    {
        return std::to_integer<std::uint32_t>(from[x / pixels_per_byte]) >> shift(x) & max;
    }

    void store(int x, std::uint32_t pixel)
    {
        std::byte& at = row[x / pixels_per_byte];
        const auto others = std::to_integer<std::uint32_t>(at) & ~(max << shift(x));
        at = static_cast<std::byte>(others | pixel << shift(x));
    }
};

template <>
struct PixelRow<PixelFormat::grey4> : BrightnessRow<4> {
};

template <>
struct PixelRow<PixelFormat::mono1> : BrightnessRow<1> {
};

}
