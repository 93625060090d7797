#include "core/slab_sweep.hpp"

#include "core/work.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

/// May be more than Fixed holds.
std::int64_t distance(Fixed from, Fixed to) { return std::int64_t{to.raw()} - from.raw(); }

}

void SlabSweep::run()
{
    for (; y_ < bottom_; y_ = slab_end_) {
        did(Work::slab);
        line_.take_up(y_);
        slab_end_ = next_event();
        if (line_.layer().active == Chain::none)
            continue;
        sort();
        slab_end_ = first_crossing();
        fill();
    }
}

std::int32_t SlabSweep::next_event() const
{
    std::int32_t end = bottom_;
    if (line_.has_waiting())
        end = std::min(end, line_.next_top());
    for (std::uint16_t i = line_.layer().active; i != Chain::none; i = line_.chain(i).next)
        end = std::min(end, edge_end(line_.store(), line_.chain(i)));
    return end;
}

Fixed SlabSweep::x_at_slab_end(const Chain& chain) const
{
    return current_edge(line_.store(), chain).x_at(slab_end_, chain.slope);
}

bool SlabSweep::is_left_of(const Chain& a, const Chain& b) const
{
    return a.x < b.x || (a.x == b.x && x_at_slab_end(a) < x_at_slab_end(b));
}

/// Insertion sort: from row to row the order hardly changes.
void SlabSweep::sort()
{
    std::uint16_t& first = line_.layer().active;
    std::uint16_t rest = std::exchange(first, Chain::none);
    std::uint16_t last = Chain::none;
    while (rest != Chain::none) {
        const std::uint16_t number = std::exchange(rest, line_.chain(rest).next);
        Chain& chain = line_.chain(number);
        std::uint16_t* link = &first;
        if (last != Chain::none && !is_left_of(chain, line_.chain(last)))
            link = &line_.chain(last).next;
        while (*link != Chain::none && !is_left_of(chain, line_.chain(*link)))
            link = &line_.chain(*link).next;
        chain.next = std::exchange(*link, number);
        if (chain.next == Chain::none)
            last = number;
    }
}

/// The first sub-row at which two neighbours have changed sides; the end of the slab if none do.
std::int32_t SlabSweep::first_crossing() const
{
    std::int32_t first = slab_end_;
    const Chain* left = &line_.chain(line_.layer().active);
    Fixed left_end = x_at_slab_end(*left);
    while (left->next != Chain::none) {
        const Chain* right = &line_.chain(left->next);
        const Fixed right_end = x_at_slab_end(*right);
        if (right_end < left_end)
            first = std::min(first, crossing(distance(left->x, right->x), distance(right_end, left_end)));
        left = right;
        left_end = right_end;
    }
    return first;
}

/// Where a distance of `before` at y_ has shrunk to -`after` at the end of the slab passes through 0, rounded
/// up to a sub-row.
std::int32_t SlabSweep::crossing(std::int64_t before, std::int64_t after) const
{
    const std::int64_t whole = before + after;
    const std::int64_t part = ((slab_end_ - y_) * before + whole - 1) / whole;
    return y_ + std::max(static_cast<std::int32_t>(part), std::int32_t{1});
}

/// Accumulates the slab and moves its edges to its end.
void SlabSweep::fill()
{
    const FillRule rule = line_.layer().rule;
    std::int32_t winding = 0;
    std::uint16_t* link = &line_.layer().active;
    while (*link != Chain::none) {
        did(Work::slab_edge);
        Chain& chain = line_.chain(*link);
        const bool was_inside = is_inside(rule, winding);
        winding += chain.winding();
        if (is_inside(rule, winding) != was_inside)
            coverage_.add(chain.x, x_at_slab_end(chain), slab_end_ - y_, was_inside ? -1 : 1);
        if (line_.move_to(chain, slab_end_))
            link = &chain.next;
        else
            *link = chain.next;
    }
}

}
