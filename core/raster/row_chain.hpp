#pragma once

#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/grid.hpp"

#include <cstdint>

namespace kfast::raster {

/// A chain as it goes through a row. x is counted from the left border of a tile, y from the upper border of
/// the row, both in the grid.
struct RowChain {
    std::int32_t top_x;    ///< where it enters the row …
    std::int32_t bottom_x; ///< … and where it leaves it
    const Bend* bend;      ///< the first one that may lie in the row
    std::int32_t left;     ///< of the tile, counted as the x of bends is
    std::int32_t top;      ///< of the row, counted as the y of bends is
    std::int32_t from;     ///< y where it enters the row …
    std::int32_t to;       ///< … and where it leaves it
    int first;             ///< the leftmost pixel that it touches
    int last;              ///< the rightmost one
    bool runs_down;
    bool is_straight; ///< from the upper border to the lower one, as one edge
    bool begins;      ///< at `from`; a level edge may follow

    /// Finds the first pixel and the last one, of those that its chain has in the band.
    void find_pixels();
    /// Where it crosses a height that lies within it.
    std::int32_t x_at(std::int32_t y) const;

    /// Of its winding, in the grid.
    std::int32_t height() const { return runs_down ? to - from : from - to; }

    /// Whether a bend that lies above its lower end is part of it, and not of the row above.
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

}
