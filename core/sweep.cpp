// The area that a set of outlines encloses, pixel by pixel.
//
// Accumulating the signed area of every edge on its own, as font rasterizers do, counts twice what two
// outlines cover together within one pixel: where the round caps of two strokes meet, their soft edges would
// grow hard. So the winding number has to tell which edges bound the filled area.
//
// In most rows chains pass side by side: from left to right the winding number is then the same in the whole
// row (RowParts). Any other row is swept slab by slab (SlabSweep).

#include "core/sweep.hpp"

#include "core/row_parts.hpp"
#include "core/slab_sweep.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <limits>

namespace kfast {
namespace {

/// A row in which chains pass side by side.
class RowSweep {
public:
    RowSweep(SweepLine& line, const RowParts& parts, std::int32_t row_end, CoverageRow& coverage)
        : line_{line}, parts_{parts}, row_end_{row_end}, coverage_{coverage}
    {
    }

    /// As sweep_row(); moves the line below the row.
    void run(Crossings& crossings, bool wants_coverage)
    {
        Layer& layer = line_.layer();
        const bool run_through = parts_.run_through();
        std::int32_t winding = 0;
        bool was_inside = false;
        std::uint16_t* link = &layer.active;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const RowPart& part = parts_[i];
            winding += part.chain->winding();
            if (is_inside(layer.rule, winding) != was_inside) {
                if (run_through)
                    add_crossing(part, crossings);
                if (wants_coverage || !run_through)
                    cover(part, was_inside ? -1 : 1);
                was_inside = !was_inside;
            }
            if (take(part)) {
                *link = part.number;
                link = &part.chain->next;
            }
        }
        *link = Chain::none;
        while (line_.has_waiting() && line_.next_top() < row_end_)
            ++layer.waiting;
    }

private:
    static void add_crossing(const RowPart& part, Crossings& crossings)
    {
        if (part.is_straight)
            crossings.add(Fixed::from_raw(part.begin), Fixed::from_raw(part.end), false);
        else
            crossings.add(Fixed::from_raw(part.left), Fixed::from_raw(part.right), true);
    }

    void cover(const RowPart& part, std::int32_t sign)
    {
        coverage_.touch(Fixed::from_raw(part.left), Fixed::from_raw(part.right));
        if (part.is_straight)
            coverage_.add_touched(Fixed::from_raw(part.begin), Fixed::from_raw(part.end), subrows, sign);
        else
            cover_bent(part, sign);
    }

    void cover_bent(const RowPart& part, std::int32_t sign)
    {
        Fixed x = Fixed::from_raw(part.begin);
        std::int32_t y = part.top;
        const Corner* corner = current_edge(line_.store(), *part.chain).lower;
        const std::ptrdiff_t onward = part.chain->runs_up != 0 ? -1 : 1;
        for (std::int32_t i = 0; i < part.corners; ++i, corner += onward) {
            coverage_.add_touched(x, corner->x, corner->y - y, sign);
            x = corner->x;
            y = corner->y;
        }
        coverage_.add_touched(x, Fixed::from_raw(part.end), part.bottom - y, sign);
    }

    /// Moves the chain below the row. Whether anything of it is left there.
    static bool take(const RowPart& part)
    {
        Chain& chain = *part.chain;
        if (part.corners == 0) {
            chain.x = Fixed::from_raw(part.end);
        } else if (!part.is_over) {
            chain.passed = static_cast<std::uint16_t>(chain.passed + part.corners);
            chain.x = Fixed::from_raw(part.next_x);
            chain.slope = part.next_slope;
        }
        return !part.is_over;
    }

    SweepLine& line_;
    const RowParts& parts_;
    std::int32_t row_end_;
    CoverageRow& coverage_;
};

/// The columns that outlines may reach: a sweep rounds slopes, which takes x up to 1/100 px past a corner,
/// and then x.
void find_columns(const OutlineStore& store, Layer& layer)
{
    std::int32_t left = std::numeric_limits<std::int32_t>::max();
    std::int32_t right = std::numeric_limits<std::int32_t>::min();
    for (std::int32_t i = layer.outlines.first_corner; i != layer.outlines.end_corner; ++i) {
        left = std::min(left, store.corner(i).x.raw());
        right = std::max(right, store.corner(i).x.raw());
    }
    layer.left = static_cast<std::int16_t>((left >> 16) - 1);
    layer.right = static_cast<std::int16_t>((right >> 16) + 2);
}

void find_rows(const OutlineStore& store, Layer& layer)
{
    std::int32_t top = std::numeric_limits<std::int32_t>::max();
    std::int32_t bottom = 0;
    for (std::uint16_t i = layer.outlines.first_chain; i != layer.outlines.end_chain; ++i) {
        const Chain& chain = store.chain(i);
        const std::int32_t last = chain.runs_up != 0 ? chain.first - chain.edges : chain.first + chain.edges;
        top = std::min(top, store.corner(chain.first).y);
        bottom = std::max(bottom, store.corner(last).y);
    }
    constexpr std::int32_t most = std::numeric_limits<std::int16_t>::max();
    layer.top = static_cast<std::int16_t>(std::max(top, std::int32_t{0}) / subrows);
    layer.bottom = static_cast<std::int16_t>(std::min((bottom + subrows - 1) / subrows, most));
}

}

Layer layer_of(OutlineStore& store, const OutlineRange& outlines)
{
    Layer layer;
    layer.outlines = outlines;
    if (outlines.empty())
        return layer;
    store.sort(outlines);
    find_rows(store, layer);
    find_columns(store, layer);
    layer.rewind();
    return layer;
}

bool sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage, Crossings& crossings,
               bool wants_coverage)
{
    did(Work::swept_row);
    if (row < layer.row)
        layer.rewind();
    SweepLine line{store, layer};
    const std::int32_t top = row * subrows;
    if (layer.row != row)
        line.move_to(top);
    layer.row = static_cast<std::int16_t>(row + 1);
    line.take_up(top);
    crossings.count = 0;
    RowParts parts{line, top};
    if (!parts.find() || !parts.stand_apart()) {
        SlabSweep{line, top, coverage}.run();
        return false;
    }
    RowSweep{line, parts, top + subrows, coverage}.run(crossings, wants_coverage);
    return parts.run_through();
}

void sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage)
{
    Crossings crossings;
    sweep_row(store, layer, row, coverage, crossings, true);
}

}
