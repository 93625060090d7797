#pragma once

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/raster/coverage.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// How colours are mixed while rows are composed. An ink is a colour as it is mixed; a cell holds a pixel.
///
/// Red, green and blue in 5, 6 and 5 bits: the cells of an RGB565 panel. Inks have room for 5 bits below each
/// channel, so that one multiplication mixes all of them, in 32 steps.
struct Rgb565Cells {
    using Cell = std::uint16_t;
    static constexpr std::uint32_t full_share = 32;

    static constexpr std::uint32_t ink(Colour colour)
    {
        return spread(narrow_channel(colour.red, 31) << 11 | narrow_channel(colour.green, 63) << 5 |
                      narrow_channel(colour.blue, 31));
    }
    static constexpr Cell cell(std::uint32_t ink) { return static_cast<Cell>(ink | ink >> 16); }
    static constexpr std::uint32_t ink_of(Cell cell) { return spread(cell); }

    /// The fraction of a pixel that is mixed for a coverage of 0 … full_coverage, rounded to nearest.
    static constexpr std::uint32_t share(std::int32_t coverage)
    {
        return (static_cast<std::uint32_t>(coverage) + 4) >> 3;
    }
    static constexpr std::uint32_t mixed(std::uint32_t under, std::uint32_t over, std::uint32_t share)
    {
        constexpr std::uint32_t half = 16U | 16U << 11 | 16U << 21;
        return ((((over - under) * share + half) >> 5) + under) & channels;
    }

private:
    static constexpr std::uint32_t channels = 0x07E0'F81F;
    static constexpr std::uint32_t spread(std::uint32_t pixel) { return (pixel | pixel << 16) & channels; }
};

/// 8 bits a channel, for panels with more than 5 bits a channel, or other numbers of them.
struct Rgb888Cells {
    using Cell = std::uint32_t;
    static constexpr std::uint32_t full_share = 256;

    static constexpr std::uint32_t ink(Colour colour)
    {
        return std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 | colour.blue;
    }
    static constexpr Cell cell(std::uint32_t ink) { return ink; }
    static constexpr std::uint32_t ink_of(Cell cell) { return cell; }
    static constexpr std::uint32_t share(std::int32_t coverage)
    {
        return static_cast<std::uint32_t>(coverage);
    }
    static constexpr std::uint32_t mixed(std::uint32_t under, std::uint32_t over, std::uint32_t share)
    {
        constexpr std::uint32_t sides = 0x00FF'00FF;
        constexpr std::uint32_t middle = 0x0000'FF00;
        const std::uint32_t rest = full_share - share;
        const std::uint32_t red_blue = (under & sides) * rest + (over & sides) * share + 0x0080'0080;
        const std::uint32_t green = (under & middle) * rest + (over & middle) * share + 0x0000'8000;
        return (red_blue >> 8 & sides) | (green >> 8 & middle);
    }
};

/// Brightness in 8 bits, for panels in grey and in one bit.
struct GreyCells {
    using Cell = std::uint8_t;
    static constexpr std::uint32_t full_share = 256;

    static constexpr std::uint32_t ink(Colour colour) { return brightness(colour); }
    static constexpr Cell cell(std::uint32_t ink) { return static_cast<Cell>(ink); }
    static constexpr std::uint32_t ink_of(Cell cell) { return cell; }
    static constexpr std::uint32_t share(std::int32_t coverage)
    {
        return static_cast<std::uint32_t>(coverage);
    }
    static constexpr std::uint32_t mixed(std::uint32_t under, std::uint32_t over, std::uint32_t share)
    {
        return (under * (full_share - share) + over * share + 128) >> 8;
    }
};

/// How much of an ink is mixed in if it is not opaque: its opacity, 0 … 255, as a fraction.
template <class Cells>
constexpr std::uint32_t opacity_share(std::uint32_t opacity)
{
    expects(opacity <= 255);
    return (opacity * Cells::full_share + 127) / 255;
}

/// A fraction of a fraction, rounded to nearest.
template <class Cells>
constexpr std::uint32_t product_of_shares(std::uint32_t a, std::uint32_t b)
{
    return (a * b + Cells::full_share / 2) / Cells::full_share;
}

/// The size of the cells of a tile.
inline constexpr std::size_t tile_bytes = 512;

/// Pixels of a few rows of a band that are painted together.
template <class Cells>
struct Tile {
    using Cell = typename Cells::Cell;

    Cell* cells = nullptr; ///< the leftmost pixel of the first row
    int stride = 0;        ///< cells from a row to the next
    int left = 0;          ///< column of the panel
    int columns = 0;       ///< at most tile_columns
    int first_row = 0;     ///< of the band
    int rows = 0;
};

inline void note_fill(int count)
{
    count_op(Op::fill);
    count_op(Op::filled_pixel, static_cast<std::uint32_t>(count));
}

template <class Cell>
[[gnu::noinline]] void fill(Cell* at, int count, Cell cell)
{
    note_fill(count);
    for (Cell* const end = at + count; at != end; ++at)
        *at = cell;
}

/// Shorter runs are filled cell by cell.
inline constexpr int short_stretch = 12;

/// Fills two cells at a time, as words.
[[gnu::noinline]] inline void fill_pairs(std::uint16_t* at, int count, std::uint16_t cell)
{
    if ((reinterpret_cast<std::uintptr_t>(at) & 2) != 0) {
        *at++ = cell;
        --count;
    }
    const std::uint32_t both = cell * 0x0001'0001U;
    auto* word = reinterpret_cast<std::uint32_t*>(at);
    for (; count >= 2; count -= 2)
        *word++ = both;
    if (count > 0)
        *reinterpret_cast<std::uint16_t*>(word) = cell;
}

[[gnu::noinline]] inline void fill(std::uint16_t* at, int count, std::uint16_t cell)
{
    note_fill(count);
    if (count >= short_stretch)
        return fill_pairs(at, count, cell);
    for (; count > 0; --count)
        *at++ = cell;
}

}
