#pragma once

#include "core/pixel/pixel_coding.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// The ordered dither of an 8 x 8 Bayer matrix: which pixels of a panel are lit at a brightness of 0 … 255.
/// It depends on the position on the panel alone; round(64 x brightness / 255) of every 8 x 8 pixels are lit.
class Dither {
public:
    constexpr Dither()
    {
        for (std::uint32_t i = 0; i < thresholds_.size(); ++i)
            thresholds_[i] = static_cast<std::uint8_t>((2 * rank(i & 7, i >> 3) + 1) * 255 / 128);
    }

    constexpr bool is_lit(std::uint32_t brightness, int x, int y) const
    {
        return brightness > thresholds_[static_cast<std::size_t>((y & 7) << 3 | (x & 7))];
    }

    /// Eight pixels of row y from a column on that is a multiple of 8, the leftmost in the highest bit.
    constexpr std::uint32_t eight(std::uint32_t brightness, int y) const
    {
        std::uint32_t pixels = 0;
        for (int x = 0; x < 8; ++x)
            pixels = pixels << 1 | (is_lit(brightness, x, y) ? 1U : 0U);
        return pixels;
    }

private:
    /// 0 … 63: the bits of x ^ y and y alternately, the lowest first.
    static constexpr std::uint32_t rank(std::uint32_t x, std::uint32_t y)
    {
        std::uint32_t rank = 0;
        for (int bit = 0; bit < 3; ++bit)
            rank = rank << 2 | ((x ^ y) >> bit & 1) << 1 | (y >> bit & 1);
        return rank;
    }

    std::array<std::uint8_t, 64> thresholds_{};
};

inline constexpr Dither dither;

/// Paints runs of pixels in one row of an area of the panel. All columns are the panel's.
template <PixelFormat format>
struct PixelRow {
    std::byte* first; ///< where the pixel of column `left` begins; aligned to 2 if pixels are 16 bits
    int left;         ///< a multiple of pixels_in_whole_bytes(format)
    int y;            ///< the panel's row

    static constexpr std::uint32_t ink(Colour colour) { return Coding::ink(colour); }

    void fill(int x, int count, std::uint32_t ink) { Coding::fill(first, x - left, count, ink); }

    /// Blends ink over the pixels with a coverage of 0 … 255.
    void blend(int x, int count, std::uint32_t ink, std::uint32_t coverage)
    {
        for (int i = x - left; count > 0; ++i, --count)
            Coding::store(first, i, Coding::mixed(Coding::load(first, i), ink, coverage));
    }

    /// Makes what was painted since `before` was kept as transparent as `opacity` (0 … 255) says. `before` is
    /// a copy of the row from `first` on.
    void fade_from(const std::byte* before, int x, int width, std::uint32_t opacity)
    {
        for (int i = x - left; width > 0; ++i, --width)
            Coding::store(first, i, Coding::mixed(Coding::load(before, i), Coding::load(first, i), opacity));
    }

private:
    using Coding = PixelCoding<format>;
};

/// A pixel is only lit or not. What is blended over it is mixed with black or white, and the result
/// is compared with the threshold at its position.
template <>
struct PixelRow<PixelFormat::mono1_dithered> {
    std::byte* first;
    int left;
    int y;

    /// The brightness, 0 … 255.
    static constexpr std::uint32_t ink(Colour colour) { return brightness(colour); }

    void fill(int x, int count, std::uint32_t ink)
    {
        fill_bits(first, x - left, x - left + count, dither.eight(ink, y));
    }

    void blend(int x, int count, std::uint32_t ink, std::uint32_t coverage)
    {
        for (; count > 0; ++x, --count)
            lay(x, level(first, x), ink, coverage);
    }

    /// As in the other formats.
    void fade_from(const std::byte* before, int x, int width, std::uint32_t opacity)
    {
        for (; width > 0; ++x, --width)
            lay(x, level(before, x), level(first, x), opacity);
    }

private:
    using Bits = PixelCoding<PixelFormat::mono1>;

    std::uint32_t level(const std::byte* row, int x) const { return Bits::load(row, x - left) * 255; }

    void lay(int x, std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
    {
        const bool is_lit = dither.is_lit(blend_channel(under, over, coverage), x, y);
        Bits::store(first, x - left, is_lit ? 1 : 0);
    }
};

}
