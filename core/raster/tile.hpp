#pragma once

#include "core/bytes/work.hpp"
#include "core/raster/cells.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// Of the cells of a tile.
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
    did(Work::fill);
    did(Work::filled_pixel, static_cast<std::uint32_t>(count));
}

template <class Cell>
[[gnu::noinline]] void fill(Cell* at, int count, Cell cell)
{
    note_fill(count);
    for (Cell* const end = at + count; at != end; ++at)
        *at = cell;
}

/// Shorter stretches are filled cell by cell.
inline constexpr int short_stretch = 12;

/// Pairs of cells in words.
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
