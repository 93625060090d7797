// The area that a set of outlines encloses, pixel by pixel, exactly.
//
// Accumulating the signed area of every edge on its own, as font rasterizers do, counts twice what two
// outlines cover together within one pixel: where the round caps of two strokes meet, their soft edges would
// grow hard. So the winding number has to tell which edges bound the filled area.
//
// In most rows the chains run through from the upper to the lower border without touching each other: from
// left to right the winding number is then the same in the whole row. Any other row is cut into slabs, at
// every sub-row where an edge begins, ends or crosses another; within a slab the edges do not change their
// order.

#include "core/sweep.hpp"

#include "core/chain_edge.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>

namespace kfast {
namespace {

/// May be more than Fixed holds.
std::int64_t distance(Fixed from, Fixed to) { return std::int64_t{to.raw()} - from.raw(); }

class RowSweep {
public:
    RowSweep(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage)
        : store_{store}, layer_{layer}, coverage_{coverage}, y_{row * subrows}, bottom_{y_ + subrows}
    {
    }

    /// From the border of rows on that the sweep stands at; as sweep_row().
    bool run(Crossings& crossings, bool wants_coverage)
    {
        did(Work::swept_row);
        activate();
        crossings.count = 0;
        if (take_straight_row(crossings, wants_coverage))
            return true;
        if (!find_parts() || !parts_stand_apart()) {
            fill_slabs();
            return false;
        }
        const bool all_run_through = find_crossings(crossings);
        take_parts(wants_coverage || !all_run_through);
        return all_run_through;
    }

    /// Brings the sweep, which stands at a border above it, to the upper border of the row.
    void bring_down()
    {
        std::uint16_t* link = &layer_.active;
        while (*link != Chain::none) {
            Chain& chain = store_.chain(*link);
            if (move_to(chain, y_))
                link = &chain.next;
            else
                *link = chain.next;
        }
    }

private:
    std::int32_t top_of(std::uint16_t chain) const { return store_.corner(store_.chain(chain).first).y; }
    std::int32_t next_top() const { return top_of(layer_.waiting); }

    /// Takes up the chains that begin at y_ or above it.
    void activate()
    {
        for (; layer_.waiting != layer_.outlines.end_chain && next_top() <= y_; ++layer_.waiting) {
            Chain& chain = store_.chain(layer_.waiting);
            chain.passed = 0;
            enter_edge(chain);
            if (move_to(chain, y_))
                chain.next = std::exchange(layer_.active, layer_.waiting);
        }
    }

    void enter_edge(Chain& chain) const
    {
        did(Work::edge);
        const ChainEdge edge = current_edge(store_, chain);
        chain.x = edge.upper->x;
        if (edge.height() >= subrows)
            chain.slope = row_slope(edge);
    }

    /// Whether anything of the chain is left below `subrow`, which is not above where it stands.
    bool move_to(Chain& chain, std::int32_t subrow) const
    {
        ChainEdge edge = current_edge(store_, chain);
        while (edge.lower->y <= subrow) {
            if (++chain.passed == chain.edges)
                return false;
            enter_edge(chain);
            edge = current_edge(store_, chain);
        }
        chain.x = edge.x_at(subrow, chain.slope);
        return true;
    }

    /// Most rows: chains run through, each to the left of the next, with no more than a slight bend. Whether
    /// it was such a row.
    bool take_straight_row(Crossings& crossings, bool wants_coverage)
    {
        if (layer_.waiting != layer_.outlines.end_chain && next_top() < bottom_)
            return false;
        std::array<std::int32_t, Crossings::most> ends;   // of the chains, in 1/65536 px
        std::array<std::int32_t, Crossings::most> slopes; // of the next edges, of chains that are bent
        std::uint32_t bent = 0;                           // a bit for each chain
        std::int32_t last = std::numeric_limits<std::int32_t>::min();
        std::size_t count = 0;
        for (std::uint16_t i = layer_.active; i != Chain::none; ++count) {
            const Chain& chain = store_.chain(i);
            if (count == Crossings::most)
                return false;
            std::int32_t end;
            if (lower_end(store_, chain).y > bottom_) {
                end = chain.x.raw() + chain.slope;
            } else if (bends_slightly(chain, slopes[count])) {
                end = following_edge(store_, chain).x_at(bottom_, slopes[count]).raw();
                bent |= 1U << count;
            } else {
                return false;
            }
            if (chain.x.raw() < last || end < last)
                return false;
            ends[count] = end;
            last = std::max(chain.x.raw(), end);
            i = chain.next;
        }
        std::int32_t winding = 0;
        count = 0;
        for (std::uint16_t i = layer_.active; i != Chain::none; ++count) {
            Chain& chain = store_.chain(i);
            i = chain.next;
            const Fixed begin = chain.x;
            chain.x = Fixed::from_raw(ends[count]);
            did(Work::straight_part);
            if ((bent >> count & 1) != 0) {
                ++chain.passed;
                chain.slope = slopes[count];
            }
            const bool was_inside = is_inside(winding);
            winding += chain.winding();
            if (is_inside(winding) == was_inside)
                continue;
            crossings.add(begin, chain.x, false);
            if (wants_coverage)
                coverage_.add(begin, chain.x, subrows, was_inside ? -1 : 1);
        }
        return true;
    }

    /// Whether the chain, whose edge ends in the row, goes on through it as another one, of `slope`, that
    /// stands nearly in the same direction.
    bool bends_slightly(const Chain& chain, std::int32_t& slope) const
    {
        constexpr std::int32_t slight = Fixed::one / 8; // the triangle on the chord has an area of 1/8 of it
        if (chain.passed + 1 == chain.edges)
            return false;
        const ChainEdge before = current_edge(store_, chain);
        const ChainEdge edge = following_edge(store_, chain);
        if (before.height() < subrows || edge.height() < subrows || edge.lower->y <= bottom_)
            return false;
        did(Work::edge);
        slope = row_slope(edge);
        return before.lower->y == bottom_ || std::abs(slope - chain.slope) <= slight;
    }

    /// What a row cuts out of a chain.
    struct Part {
        std::uint16_t chain;
        std::int8_t winding;
        bool is_straight; ///< and runs through the row, perhaps with a slight bend
        bool has_corner;  ///< within the row, but no slight bend
        bool is_bent;     ///< slightly: the next edge has `slope`
        std::int32_t slope;
        std::int32_t top;
        std::int32_t bottom;
        Fixed begin{}; ///< x at the top
        Fixed left{};
        Fixed right{};
    };

    static constexpr std::size_t most_parts = 12;

    /// From left to right; false if there are too many. Nothing is moved yet.
    bool find_parts()
    {
        for (std::uint16_t i = layer_.active; i != Chain::none; i = store_.chain(i).next)
            if (!add_part(i, store_.chain(i)))
                return false;
        for (std::uint16_t i = layer_.waiting; i != layer_.outlines.end_chain && top_of(i) < bottom_; ++i) {
            Chain& chain = store_.chain(i);
            chain.passed = 0;
            enter_edge(chain);
            if (!add_part(i, chain))
                return false;
        }
        return true;
    }

    bool add_part(std::uint16_t number, const Chain& chain)
    {
        if (part_count_ == most_parts)
            return false;
        did(Work::part);
        Part& part = parts_[part_count_];
        const bool is_under_way = number < layer_.waiting;
        if (is_under_way && lower_end(store_, chain).y > bottom_)
            make_straight(part, chain, chain.x + Fixed::from_raw(chain.slope));
        else if (is_under_way && bends_slightly(chain, part.slope))
            make_straight(part, chain, following_edge(store_, chain).x_at(bottom_, part.slope));
        else
            make_bent(part, chain);
        part.chain = number;
        part.winding = static_cast<std::int8_t>(chain.winding());
        std::size_t at = part_count_++;
        for (; at > 0 && part.left < parts_[order_[at - 1]].left; --at)
            order_[at] = order_[at - 1];
        order_[at] = static_cast<std::uint8_t>(part_count_ - 1);
        return true;
    }

    void make_straight(Part& part, const Chain& chain, Fixed end) const
    {
        part.is_straight = true;
        part.has_corner = false;
        part.is_bent = lower_end(store_, chain).y <= bottom_;
        part.top = y_;
        part.bottom = bottom_;
        part.begin = chain.x;
        part.left = std::min(chain.x, end);
        part.right = std::max(chain.x, end);
    }

    void make_bent(Part& part, const Chain& chain) const
    {
        did(Work::bent_part);
        std::int32_t passed = chain.passed;
        ChainEdge edge = edge_of(store_, chain, passed);
        part.is_straight = false;
        part.has_corner = false;
        part.top = std::max(y_, edge.upper->y);
        part.bottom = bottom_;
        part.begin = part.left = part.right = chain.x;
        const auto stretch = [&part](Fixed x) {
            part.left = std::min(part.left, x);
            part.right = std::max(part.right, x);
        };
        for (; edge.lower->y < bottom_; edge = edge_of(store_, chain, passed)) {
            stretch(edge.lower->x);
            part.has_corner = true;
            if (++passed == chain.edges) {
                part.bottom = edge.lower->y;
                return;
            }
        }
        stretch(edge.x_at(bottom_, edge.height() >= subrows ? row_slope(edge) : 0));
    }

    /// From left to right.
    const Part& part(std::size_t number) const { return parts_[order_[number]]; }

    /// Whether each part lies wholly to the left of the next and has the same winding number to its left all
    /// along: what does not run through the row comes in pairs that enclose something.
    bool parts_stand_apart() const
    {
        for (std::size_t i = 1; i < part_count_; ++i)
            if (part(i).left < part(i - 1).right)
                return false;
        for (std::size_t i = 0; i < part_count_; ++i) {
            const Part& a = part(i);
            if (a.top == y_ && a.bottom == bottom_)
                continue;
            if (++i == part_count_ || part(i).top != a.top || part(i).bottom != a.bottom ||
                part(i).winding + a.winding != 0)
                return false;
        }
        return true;
    }

    /// Whether all parts run through.
    bool find_crossings(Crossings& crossings) const
    {
        std::int32_t winding = 0;
        for (std::size_t i = 0; i < part_count_; ++i) {
            const Part& part = this->part(i);
            if (part.top != y_ || part.bottom != bottom_)
                return false;
            const bool was_inside = is_inside(winding);
            winding += part.winding;
            if (is_inside(winding) != was_inside)
                add_crossing(part, crossings);
        }
        return true;
    }

    static void add_crossing(const Part& part, Crossings& crossings)
    {
        if (part.has_corner || part.left == part.begin)
            crossings.add(part.left, part.right, part.has_corner);
        else
            crossings.add(part.right, part.left, false);
    }

    /// Moves the chains below the row and adds what they enclose there.
    void take_parts(bool wants_coverage)
    {
        std::int32_t winding = 0;
        std::uint16_t* link = &layer_.active;
        for (std::size_t i = 0; i < part_count_; ++i) {
            const Part& part = this->part(i);
            const bool was_inside = is_inside(winding);
            winding += part.winding;
            const std::int32_t sign = !wants_coverage || is_inside(winding) == was_inside ? 0
                                      : was_inside                                        ? -1
                                                                                          : 1;
            Chain& chain = store_.chain(part.chain);
            if (take_part(chain, part, sign)) {
                *link = part.chain;
                link = &chain.next;
            }
        }
        *link = Chain::none;
        while (layer_.waiting != layer_.outlines.end_chain && next_top() < bottom_)
            ++layer_.waiting;
    }

    /// Whether anything of the chain is left below the row.
    bool take_part(Chain& chain, const Part& part, std::int32_t sign)
    {
        if (!part.is_straight)
            return take_bent_part(chain, part.top, sign);
        const Fixed end = part.left == part.begin ? part.right : part.left;
        coverage_.add(chain.x, end, subrows, sign);
        chain.x = end;
        if (part.is_bent) {
            ++chain.passed;
            chain.slope = part.slope;
        }
        return true;
    }

    bool take_bent_part(Chain& chain, std::int32_t y, std::int32_t sign)
    {
        ChainEdge edge = current_edge(store_, chain);
        for (; edge.lower->y <= bottom_; edge = current_edge(store_, chain)) {
            coverage_.add(chain.x, edge.lower->x, edge.lower->y - y, sign);
            y = edge.lower->y;
            if (++chain.passed == chain.edges)
                return false;
            enter_edge(chain);
        }
        const Fixed end = edge.x_at(bottom_, chain.slope);
        coverage_.add(chain.x, end, bottom_ - y, sign);
        chain.x = end;
        return true;
    }

    void fill_slabs()
    {
        for (; y_ < bottom_; y_ = slab_end_) {
            did(Work::slab);
            activate();
            slab_end_ = next_event();
            if (layer_.active == Chain::none)
                continue;
            sort_active();
            slab_end_ = first_crossing();
            fill_slab();
        }
    }

    std::int32_t next_event() const
    {
        std::int32_t end = bottom_;
        if (layer_.waiting != layer_.outlines.end_chain)
            end = std::min(end, next_top());
        for (std::uint16_t i = layer_.active; i != Chain::none; i = store_.chain(i).next)
            end = std::min(end, current_edge(store_, store_.chain(i)).lower->y);
        return end;
    }

    Fixed x_at_slab_end(const Chain& chain) const
    {
        return current_edge(store_, chain).x_at(slab_end_, chain.slope);
    }

    bool is_left_of(const Chain& a, const Chain& b) const
    {
        return a.x < b.x || (a.x == b.x && x_at_slab_end(a) < x_at_slab_end(b));
    }

    /// Insertion sort: from row to row the order hardly changes.
    void sort_active()
    {
        std::uint16_t rest = std::exchange(layer_.active, Chain::none);
        std::uint16_t last = Chain::none;
        while (rest != Chain::none) {
            const std::uint16_t number = std::exchange(rest, store_.chain(rest).next);
            Chain& chain = store_.chain(number);
            std::uint16_t* link = &layer_.active;
            if (last != Chain::none && !is_left_of(chain, store_.chain(last)))
                link = &store_.chain(last).next;
            while (*link != Chain::none && !is_left_of(chain, store_.chain(*link)))
                link = &store_.chain(*link).next;
            chain.next = std::exchange(*link, number);
            if (chain.next == Chain::none)
                last = number;
        }
    }

    /// The first sub-row at which two neighbours have changed sides; the end of the slab if none do.
    std::int32_t first_crossing() const
    {
        std::int32_t first = slab_end_;
        const Chain* left = &store_.chain(layer_.active);
        Fixed left_end = x_at_slab_end(*left);
        while (left->next != Chain::none) {
            const Chain* right = &store_.chain(left->next);
            const Fixed right_end = x_at_slab_end(*right);
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
        while (*link != Chain::none) {
            did(Work::slab_edge);
            Chain& chain = store_.chain(*link);
            const bool was_inside = is_inside(winding);
            winding += chain.winding();
            if (is_inside(winding) != was_inside)
                coverage_.add(chain.x, x_at_slab_end(chain), slab_end_ - y_, was_inside ? -1 : 1);
            if (move_to(chain, slab_end_))
                link = &chain.next;
            else
                *link = chain.next;
        }
    }

    bool is_inside(std::int32_t winding) const
    {
        return layer_.rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
    }

    OutlineStore& store_;
    Layer& layer_;
    CoverageRow& coverage_;
    std::int32_t y_;
    std::int32_t bottom_;
    std::int32_t slab_end_ = 0;
    std::array<Part, most_parts> parts_;
    std::array<std::uint8_t, most_parts> order_; ///< numbers of parts, from left to right
    std::size_t part_count_ = 0;
};

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
    layer.rewind();
    return layer;
}

bool sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage, Crossings& crossings,
               bool wants_coverage)
{
    if (row < layer.row)
        layer.rewind();
    RowSweep sweep{store, layer, row, coverage};
    if (layer.row != row)
        sweep.bring_down();
    layer.row = static_cast<std::int16_t>(row + 1);
    return sweep.run(crossings, wants_coverage);
}

void sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage)
{
    Crossings crossings;
    sweep_row(store, layer, row, coverage, crossings, true);
}

}
