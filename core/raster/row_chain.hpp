#pragma once

#include "core/bytes/expects.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/raster/coverage.hpp"
#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// A chain as it goes through a row. x is counted from the left border of a tile, y from the upper border of
/// the row, both in the grid.
struct RowChain {
    std::int32_t top_x;    ///< where it enters the row …
    std::int32_t bottom_x; ///< … and where it leaves it
    const Bend* bend;      ///< the first one that may be in the row
    std::int32_t left;     ///< of the tile, counted as the x of bends is
    std::int32_t top;      ///< of the row, counted as the y of bends is
    std::int32_t from;     ///< y where it enters the row …
    std::int32_t to;       ///< … and where it leaves it
    int first;             ///< the leftmost pixel that it touches
    int last;              ///< the rightmost one
    bool runs_down;
    bool is_straight; ///< from the upper border to the lower one, as one edge
    bool begins;      ///< whether it begins at `from`; a level edge may follow

    /// Finds the first pixel and the last one, among those that its chain has in the band.
    void find_pixels();
    /// x at a height that is within it.
    std::int32_t x_at(std::int32_t y) const;

    /// The height of its winding, in the grid.
    std::int32_t height() const { return runs_down ? to - from : from - to; }

    /// Whether a bend that is above its lower end is part of it, and not of the row above.
    bool has(const Bend& at) const { return at.y - top > from || (at.y - top == from && begins); }

    /// Calls visit(x, y, next x, next y) for its edges from the top down.
    template <class Visit>
    void each_edge(Visit visit) const
    {
        std::int32_t x = top_x;
        std::int32_t y = from;
        for (const Bend* at = bend; at->y <= top + to; --at) {
            if (!has(*at))
                continue;
            const std::int32_t next_y = at->y - top;
            visit(x, y, at->x - left, next_y);
            x = at->x - left;
            y = next_y;
        }
        visit(x, y, bottom_x, to);
    }
};

/// Where chains cross a line through a row, from left to right: a part of it at a time, for their number has
/// no limit.
///
///     begin_part() -> add() for all chains -> walk() or add_inside(), until is_complete()
class SampleLine {
public:
    static constexpr int count_in_row = 8;
    static constexpr std::size_t max_count = 16; ///< crossings in a part

    /// The n-th of a row.
    explicit SampleLine(int number) : y_{(2 * number + 1) * grid / (2 * count_in_row)}
    {
        expects(number >= 0 && number < count_in_row);
    }

    /// Begins a part to the right of the parts before.
    void begin_part();
    /// Adds a chain; in the same order for each part.
    void add(const RowChain& chain);
    /// Whether this part is the last one.
    bool is_complete() const { return !has_more_; }
    /// Notes the windings in the part.
    template <class Note>
    void walk(std::int32_t winding, Note note) const
    {
        for (std::size_t i = 0; i != count_; ++i)
            note(winding += step(i));
    }
    /// Adds a fraction of the row: what is inside on the part; `winding` is that to the left of it. Returns
    /// that to the right of it.
    std::int32_t add_inside(FillRule rule, std::int32_t winding, int columns, CoverageSums& sums) const;

private:
    /// They are in the order of their positions, then in that of add().
    struct Crossing {
        std::int32_t x2; ///< 2 x, or 2 x + 1 if the outline runs up there
        std::int32_t number;
    };

    int step(std::size_t place) const { return (crossings_[place].x2 & 1) == 0 ? 1 : -1; }

    std::int32_t y_;
    std::int32_t added_ = 0; ///< crossings, in this part and others
    std::size_t count_ = 0;
    bool has_more_ = false;
    bool is_first_ = true;
    Crossing before_{}; ///< the last one of the parts before
    std::array<Crossing, max_count> crossings_;
};

}
