#include "core/sweep_line.hpp"

#include "core/work.hpp"

#include <utility>

namespace kfast {

void enter_edge(const OutlineStore& store, Chain& chain)
{
    did(Work::edge);
    const ChainEdge edge = current_edge(store, chain);
    chain.x = edge.upper->x;
    if (edge.height() >= subrows)
        chain.slope = row_slope(edge);
}

void SweepLine::take_up(std::int32_t subrow)
{
    for (; has_waiting() && next_top() <= subrow; ++layer_.waiting) {
        Chain& chain = this->chain(layer_.waiting);
        begin(chain);
        if (move_to(chain, subrow))
            chain.next = std::exchange(layer_.active, layer_.waiting);
    }
}

void SweepLine::begin(Chain& chain)
{
    chain.passed = 0;
    enter_edge(store_, chain);
}

bool SweepLine::move_to(Chain& chain, std::int32_t subrow)
{
    while (edge_end(store_, chain) <= subrow) {
        if (++chain.passed == chain.edges)
            return false;
        enter_edge(store_, chain);
    }
    chain.x = current_edge(store_, chain).x_at(subrow, chain.slope);
    return true;
}

void SweepLine::move_to(std::int32_t subrow)
{
    std::uint16_t* link = &layer_.active;
    while (*link != Chain::none) {
        Chain& chain = this->chain(*link);
        if (move_to(chain, subrow))
            link = &chain.next;
        else
            *link = chain.next;
    }
}

}
