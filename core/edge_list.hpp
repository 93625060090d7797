#pragma once

#include "core/colour.hpp"
#include "core/fill_rule.hpp"
#include "core/fixed.hpp"
#include "core/point.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Rows are divided into 1024 sub-rows; edges begin and end on them.
inline constexpr std::int32_t subrows = 1024;

/// One side of an outline, from its upper to its lower end. Sweeping down consumes it: x and y move along.
struct Edge {
    Fixed x;                     ///< at y
    Fixed x_end;                 ///< at y_end
    Fixed slope;                 ///< of x in a whole row; only of edges that are at least one row high
    std::int32_t y = 0;          ///< in sub-rows
    std::int32_t y_end : 30;     ///< in sub-rows, larger than y
    std::int32_t winding : 2;    ///< 1 where the outline runs down, -1 where it runs up
    std::uint16_t next = 0;      ///< in the layer's list
    std::uint8_t x_rest = 0;     ///< what x lacks, in 1/256 of its unit: a row's rounding must not add up
    std::uint8_t slope_rest = 0; ///< what slope lacks, likewise

    /// x at a sub-row of y … y_end that is at most a row below y, rounded down.
    Fixed x_at(std::int32_t subrow) const;
    /// Moves y to such a sub-row.
    void advance(std::int32_t subrow);

private:
    std::int64_t fine_x_at(std::int32_t subrow) const;
};

static_assert(sizeof(Edge) == 24, "edges are most of the memory that a player borrows");

/// Edges that are painted together in one colour, as two linked lists.
struct Layer {
    static constexpr std::uint16_t no_edge = 0xFFFF;

    std::uint16_t waiting = no_edge; ///< edges that begin further down, sorted by y
    std::uint16_t active = no_edge;  ///< edges under the sweep, sorted by x
    Colour colour;
    FillRule rule = FillRule::nonzero;
};

/// The edges of one picture, in memory that the caller lends.
class EdgeList {
public:
    EdgeList(std::span<Edge> storage, int rows) : storage_{storage}, end_{rows * subrows} {}

    void clear() { count_ = 0; }
    /// Adds the way between two points of an outline of `layer`, as far as it lies within the rows.
    void add(Layer& layer, Point from, Point to);
    /// Sorts the waiting edges of a layer; to be called once, after the last add().
    void sort(Layer& layer);

    Edge& operator[](std::uint16_t index) { return storage_[index]; }
    /// Edges that were added, also those that found no room. They all find room when `storage` is as large as
    /// the scene says.
    std::size_t count() const { return count_; }

private:
    std::uint16_t merge(std::uint16_t first, std::uint16_t second);

    std::span<Edge> storage_;
    std::int32_t end_; ///< sub-row below the last one
    std::size_t count_ = 0;
};

}
