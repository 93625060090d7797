// The area that a set of edges encloses, pixel by pixel, exactly.
//
// Accumulating the signed area of every edge on its own, as font rasterizers do, counts twice what two
// outlines cover together within one pixel: where the round caps of two strokes meet, their soft edges would
// grow hard. So the row is cut into slabs at every sub-row where an edge begins, ends or crosses another.
// Within a slab the edges do not change their order: from left to right the winding number tells which of
// them bound the filled area, and only these are accumulated. Most rows are a single slab.

#include "core/sweep.hpp"

#include <utility>

namespace kfast {
namespace {

/// May be more than Fixed holds.
std::int64_t distance(Fixed from, Fixed to) { return std::int64_t{to.raw()} - from.raw(); }

class RowSweep {
public:
    RowSweep(EdgeList& edges, Layer& layer, CoverageRow& coverage)
        : edges_{edges}, layer_{layer}, coverage_{coverage}
    {
    }

    void run(std::int32_t begin, std::int32_t end)
    {
        for (y_ = begin; y_ < end; y_ = slab_end_) {
            activate();
            slab_end_ = next_event(end);
            if (layer_.active == Layer::no_edge)
                continue;
            sort_active();
            slab_end_ = first_crossing();
            fill_slab();
        }
    }

private:
    void activate()
    {
        while (layer_.waiting != Layer::no_edge && edges_[layer_.waiting].y <= y_) {
            const std::uint16_t index = std::exchange(layer_.waiting, edges_[layer_.waiting].next);
            edges_[index].next = std::exchange(layer_.active, index);
        }
    }

    std::int32_t next_event(std::int32_t end)
    {
        if (layer_.waiting != Layer::no_edge)
            end = std::min(end, edges_[layer_.waiting].y);
        for (std::uint16_t i = layer_.active; i != Layer::no_edge; i = edges_[i].next)
            end = std::min<std::int32_t>(end, edges_[i].y_end);
        return end;
    }

    bool is_left_of(const Edge& a, const Edge& b) const
    {
        return a.x < b.x || (a.x == b.x && a.x_at(slab_end_) < b.x_at(slab_end_));
    }

    /// Insertion sort: from row to row the order hardly changes.
    void sort_active()
    {
        std::uint16_t rest = std::exchange(layer_.active, Layer::no_edge);
        std::uint16_t last = Layer::no_edge;
        while (rest != Layer::no_edge) {
            const std::uint16_t index = std::exchange(rest, edges_[rest].next);
            Edge& edge = edges_[index];
            if (last != Layer::no_edge && !is_left_of(edge, edges_[last])) {
                edges_[last].next = index;
                edge.next = Layer::no_edge;
                last = index;
                continue;
            }
            std::uint16_t* link = &layer_.active;
            while (*link != Layer::no_edge && !is_left_of(edge, edges_[*link]))
                link = &edges_[*link].next;
            edge.next = std::exchange(*link, index);
            if (edge.next == Layer::no_edge)
                last = index;
        }
    }

    /// The first sub-row at which two neighbours have changed sides; the end of the slab if none do.
    std::int32_t first_crossing()
    {
        std::int32_t first = slab_end_;
        const Edge* left = &edges_[layer_.active];
        Fixed left_end = left->x_at(slab_end_);
        while (left->next != Layer::no_edge) {
            const Edge* right = &edges_[left->next];
            const Fixed right_end = right->x_at(slab_end_);
            if (right_end < left_end)
                first = std::min(first, crossing(distance(left->x, right->x), distance(right_end, left_end)));
            left = right;
            left_end = right_end;
        }
        return first;
    }

    /// Where a distance of `before` at y_ has shrunk to -`after` at the end of the slab passes through 0,
    /// rounded up to a sub-row.
    std::int32_t crossing(std::int64_t before, std::int64_t after) const
    {
        const std::int64_t whole = before + after;
        const std::int64_t part = ((slab_end_ - y_) * before + whole - 1) / whole;
        return y_ + std::max(static_cast<std::int32_t>(part), std::int32_t{1});
    }

    /// Accumulates the slab and moves its edges to its end.
    void fill_slab()
    {
        std::int32_t winding = 0;
        std::uint16_t* link = &layer_.active;
        while (*link != Layer::no_edge) {
            Edge& edge = edges_[*link];
            const Fixed begin = edge.x;
            edge.advance(slab_end_);
            const bool was_inside = is_inside(winding);
            winding += edge.winding;
            if (is_inside(winding) != was_inside)
                coverage_.add(begin, edge.x, slab_end_ - y_, was_inside ? -1 : 1);
            if (edge.y == edge.y_end)
                *link = edge.next;
            else
                link = &edge.next;
        }
    }

    bool is_inside(std::int32_t winding) const
    {
        return layer_.rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
    }

    EdgeList& edges_;
    Layer& layer_;
    CoverageRow& coverage_;
    std::int32_t y_ = 0;
    std::int32_t slab_end_ = 0;
};

}

void sweep_row(EdgeList& edges, Layer& layer, int row, CoverageRow& coverage)
{
    RowSweep{edges, layer, coverage}.run(row * subrows, (row + 1) * subrows);
}

}
