#pragma once

#include "core/bytes/expects.hpp"
#include "core/raster/outline/grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// x where a chain crosses a border between rows, in the grid, counted from Chain::left.
using Crossing = std::uint16_t;

/// A corner of a chain that is kept besides its crossings: x like these, y counted from the border of a row
/// at or above the chain's top.
struct Bend {
    static constexpr std::uint16_t no_y = 0xFFFF; ///< marks the end, after the last one

    std::uint16_t x = 0;
    std::uint16_t y = 0;
};

/// Bands are at most 2^max_band_bits rows high. Borders of such bands are borders of lower ones.
inline constexpr int max_band_bits = 3;
/// 4 rows, unless a panel asks for others.
inline constexpr int default_band_bits = 2;

/// Where a chain crosses the borders between the rows of a band.
using BandCrossings = std::array<Crossing, (1 << max_band_bits) + 1>;

/// A set of rows of a band, the first in the lowest bit. For bands that are higher than four rows all rows
/// are always in it: panels that have them take all rows together.
using RowMask = std::uint8_t;

inline constexpr RowMask all_rows = 0x0F;

/// From `begin` up to but not including `end`.
constexpr RowMask row_mask(int begin, int end)
{
    expects(begin >= 0 && begin <= end && end < 32);
    return static_cast<RowMask>(((1U << end) - (1U << begin)) & all_rows);
}

/// A long edge that is a chain of its own.
struct StraightLine {
    std::int32_t slope = 0;     ///< how far it goes to the right over each row, in 1/1024 of the grid
    Crossing top = 0;           ///< x at its upper end
    BandCrossings in_band{};    ///< of the current band
    Bend bottom{0, Bend::no_y}; ///< x at its lower end, and the end mark of its bends: it has none
};

static_assert(sizeof(StraightLine) == 28);

/// A part of an outline along which y does not change direction, cut off at the panel's upper and lower
/// border, and what it is in the current band of rows.
///
/// Of its corners these are kept: x at its top, at each border of a row that it crosses, and at its bottom
/// (crossings), and those that are too far from the line between two of these (bends). So in a row without
/// bends it is one straight edge.
struct Chain {
    static constexpr std::uint32_t none = 0;             ///< no chain has this place
    static constexpr std::size_t max_bytes = 4 * 0xFFFF; ///< with its crossings and bends

    std::int32_t top = 0;
    std::int32_t bottom = 0;
    std::uint32_t crossings = 0; ///< place of that at the band's upper border; those below it follow
    std::uint32_t bends = 0;     ///< place of the first one in the band; the others precede it in memory
    std::uint32_t next = none;   ///< place of the next chain of a list
    std::int16_t left = 0;       ///< column
    std::uint16_t layer = 0;
    bool runs_down : 1 = true;    ///< whether the outline was drawn downwards
    bool is_straight : 1 = false; ///< it is a StraightLine, which has the crossings of the band
    bool is_border : 1 = false;   ///< its layer is inside on one side of it, and outside on the other
    RowMask rows = all_rows;      ///< that it reaches
    std::uint8_t slot = 0;        ///< of the layer in the band
    bool is_whole = false;        ///< it crosses the band from border to border without bends
    std::int16_t begin = 0;       ///< first column that it touches in the band
    std::int16_t end = 0;         ///< the column after the last one
    std::int16_t height = 0;      ///< of its part of the band in the grid; negative if it runs up
    std::uint16_t words = 0;      ///< of memory, with its crossings and bends
    std::int32_t winding = 0; ///< around its layer's outlines to the left of it, times the height of the band
};

static_assert(sizeof(Chain) == 40 && sizeof(Bend) == 4);

/// Where a straight chain crosses the borders of `rows` rows of the panel, from `row` on; beyond its ends, x
/// of the end. It goes on to the right from row to row, or to the left, also where its slope is rounded.
inline void find_crossings(const Chain& chain, const StraightLine& line, int row, int rows, Crossing* out)
{
    const int top = row - floor_pixel(chain.top);
    const int end = ceil_pixel(chain.bottom) - floor_pixel(chain.top);
    const bool runs_left = line.slope < 0;
    const auto is_beyond = [&](std::int32_t x) { return runs_left ? x < line.bottom.x : x > line.bottom.x; };
    const std::int32_t first = first_crossing(line.top, line.slope, grid - (chain.top & (grid - 1)));
    std::int32_t fine = first + (top - 1) * line.slope;
    if (top > 0 && top + rows < end && !is_beyond((fine + rows * line.slope) >> 10)) {
        for (; rows >= 0; --rows, fine += line.slope)
            *out++ = static_cast<Crossing>(fine >> 10);
        return;
    }
    for (int border = top; border <= top + rows; ++border, fine += line.slope) {
        const std::int32_t x = fine >> 10;
        if (border <= 0)
            *out++ = line.top;
        else
            *out++ = border >= end || is_beyond(x) ? line.bottom.x : static_cast<Crossing>(x);
    }
}

/// Converts corners that go down all the way into what is kept of a chain.
///
///     row border  ----x------------   crossing
///                      \               corner within 5/64 px of the line between both crossings: dropped
///                       ·
///     row border  -------x---------   crossing
///                         \____.       corners further away: kept as bends
///                               |
///     row border  --------------x--   crossing
///
/// So a row is drawn from two numbers, however many corners it has, unless it has bends.
class ChainBuilder {
public:
    /// The maximum distance of corners to the right of `left`, 512 px, and below the row of the first one.
    static constexpr int reach_bits = 15;
    static constexpr std::int32_t max_height = (0xFFFF >> grid_bits) * grid;

    /// The minimum room for a chain of `corners` corners from `top` to `bottom`, in bytes below the end
    /// that is given to build(): all of its corners may have to be kept.
    static std::size_t room_for(std::size_t corners, std::int32_t top, std::int32_t bottom);

    /// The size of the crossings alone, in whole words.
    static constexpr std::uint32_t crossing_bytes(std::int32_t top, std::int32_t bottom)
    {
        return (static_cast<std::uint32_t>(ceil_pixel(bottom) - floor_pixel(top)) + 2) / 2 * 4;
    }

    /// Writes the crossings of `first`, `step` corners on, and so forth to `last`, and their bends, below
    /// `end`, which is aligned to 4. y increases from corner to corner, or stays. Returns false if a corner
    /// is out of reach.
    bool build(const Corner* first, const Corner* last, std::ptrdiff_t step, std::int32_t left,
               std::byte* end);

    const Crossing* crossings() const { return crossings_; }
    /// One past the first one; the others follow downwards.
    const Bend* bends() const { return bends_; }
    /// What was written begins here, aligned to 4.
    std::byte* memory_begin() const { return reinterpret_cast<std::byte*>(last_bend_); }

private:
    void begin(Corner first, Corner last, std::byte* end);
    /// A corner within a row; it may be dropped when the row is settled.
    void keep(std::int32_t x, std::int32_t y)
    {
        *--last_bend_ = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
    }
    void keep_for_good(std::int32_t x, std::int32_t y)
    {
        keep(x, y);
        row_bends_ = last_bend_;
    }
    void settle_row(Bend from, Bend to);

    Crossing* crossings_ = nullptr;
    Bend* bends_ = nullptr; ///< one past the first one, which is written below it
    Bend* last_bend_ = nullptr;
    Bend* row_bends_ = nullptr; ///< the last one of the rows above
};

}
