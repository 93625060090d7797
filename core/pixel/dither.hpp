#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// The ordered dither of an 8 x 8 Bayer matrix: which pixels of a panel are lit at a brightness of 0 … 255.
/// It depends on the place on the panel alone; round(64 x brightness / 255) of every 8 x 8 pixels are lit.
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
    /// 0 … 63: the bits of x ^ y and y taken in turns, the lowest first.
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

}
