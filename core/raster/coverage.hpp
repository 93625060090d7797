#pragma once

#include "core/bytes/expects.hpp"
#include "core/raster/outline/grid.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// Pixels of a row that are painted at a time: a tile.
inline constexpr int tile_columns = 64;

/// A pixel that is covered wholly.
inline constexpr std::int32_t full_coverage = 256;

/// Coverages of the pixels `begin` up to `end`.
struct CoverageRun {
    int begin = 0;
    int end = 0;
    std::array<std::uint16_t, tile_columns> pixels;
};

/// A straight edge through a row, from its upper border to its lower one or the other way: x where it begins,
/// and where it ends further to the right, in the grid.
struct RowEdge {
    std::int32_t low;
    std::int32_t high;

    int pixel() const { return floor_pixel(low); }
    /// Whether it stays within one pixel.
    bool is_steep() const { return high <= (pixel() + 1) * grid; }
    /// How much of that pixel is to the right of the edge.
    std::int32_t steep_coverage() const { return 4 * (pixel() + 1) * grid - 2 * (low + high); }
};

constexpr RowEdge edge_between(std::int32_t a, std::int32_t b)
{
    return a < b ? RowEdge{a, b} : RowEdge{b, a};
}

/// As cover(), for an edge that is not steep.
[[gnu::noinline]] void cover_flat(const RowEdge& edge, int columns, CoverageRun& run);

/// How much of the pixels that an edge touches is to the right of it, within 0 … `columns`.
inline void cover(const RowEdge& edge, int columns, CoverageRun& run)
{
    if (!edge.is_steep())
        return cover_flat(edge, columns, run);
    const int pixel = edge.pixel();
    run.begin = std::clamp(pixel, 0, columns);
    run.end = std::clamp(pixel + 1, 0, columns);
    run.pixels[0] = static_cast<std::uint16_t>(edge.steep_coverage());
}

/// Sums up the areas between edges and the right border of a tile, for one row:
///
///     sums          +a  +b  0   0  -c  -d  0      what an edge adds to its pixels
///     coverage       a a+b  1   1 1-c  0   0      the sum of all up to a pixel
class CoverageSums {
public:
    /// The sum for a pixel that is covered once.
    static constexpr std::int32_t full = full_coverage << 9;
    /// The height of an edge from one border of the row to the other.
    static constexpr std::int32_t part_height = 1024;

    /// The edge of an outline that runs down if `direction` is 1, and up if it is -1.
    void add(const RowEdge& edge, std::int32_t direction, int columns);
    /// A part of an edge, from x = a to b; `height` is negative if the outline runs up.
    void add_part(std::int32_t a, std::int32_t b, std::int32_t height, int columns);

    /// Adds a whole row `windings` times, from a column on.
    void add_windings(int column, std::int32_t windings, int columns)
    {
        put(column, windings * full, columns);
    }

    /// Adds the height of edges to the left of the tile, in the grid; negative if outlines run up.
    void add_height(std::int32_t height) { sums_[0] += height * (full / grid); }

    /// The coverage of a pixel with an area, rounded to nearest.
    static constexpr std::int32_t coverage(std::int32_t area)
    {
        constexpr std::int32_t unit = full / full_coverage;
        return (std::min(area, full) + unit / 2) / unit;
    }

    /// The coverages of an edge whose parts are all that was added, and which touches the pixels from
    /// run.begin up to run.end: what is to the right of it. The layer is inside on its left side or on its
    /// right one. Clears the sums.
    void take(bool runs_down, bool is_inside_left, CoverageRun& run);

    /// Calls span(begin, end, sum) for runs of pixels that have the same sum; to the left of them it is
    /// `sum`. Clears the sums.
    template <class Span>
    void sum_up(int columns, std::int32_t sum, Span span)
    {
        expects(columns >= 0 && columns <= tile_columns);
        std::int32_t* const begin = sums_.data();
        std::int32_t* const end = begin + columns;
        *end = 1; // ends the last run
        for (std::int32_t* at = begin; at != end;) {
            const std::int32_t* const from = at;
            sum += *at;
            *at = 0;
            do
                ++at;
            while (*at == 0);
            span(static_cast<int>(from - begin), static_cast<int>(at - begin), sum);
        }
        *end = 0;
    }

private:
    static constexpr std::int32_t whole = 2 * grid; ///< the width of a pixel, on both ends of a part

    void put(int column, std::int32_t area, int columns);
    void put_part(int column, std::int32_t height, std::int32_t ends, int columns);
    void add_wide_part(std::int32_t a, std::int32_t b, std::int32_t height, int columns);

    std::array<std::int32_t, tile_columns + 1> sums_{};
};

}
