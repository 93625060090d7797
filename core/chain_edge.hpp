#pragma once

#include "core/outline_store.hpp"

#include <cstdint>

namespace kfast {

/// The edge of a chain that a sweep stands in: two corners of a store, which must outlive it.
struct ChainEdge {
    const Corner* upper;
    const Corner* lower;

    std::int32_t height() const { return lower->y - upper->y; }

    /// x at a sub-row from its upper to its lower end, rounded down to 1/65536 px; `slope` is row_slope(),
    /// if it is a row high.
    Fixed x_at(std::int32_t subrow, std::int32_t slope) const;
};

/// How far an edge that is at least a row high moves to the right in a row, in 1/65536 px, rounded to
/// nearest: over 480 rows x is off by 1/270 px at most.
std::int32_t row_slope(const ChainEdge& edge);

/// The edge of a chain that has `passed` others above it.
inline ChainEdge edge_of(const OutlineStore& store, const Chain& chain, std::int32_t passed)
{
    const Corner* upper = &store.corner(chain.runs_up != 0 ? chain.first - passed : chain.first + passed);
    return {upper, chain.runs_up != 0 ? upper - 1 : upper + 1};
}

/// The sub-row at which the edge ends that a sweep stands in. Only while edges are left.
inline std::int32_t edge_end(const OutlineStore& store, const Chain& chain)
{
    const std::int32_t way = chain.passed + 1;
    return store.corner(chain.runs_up != 0 ? chain.first - way : chain.first + way).y;
}

/// The edge that a sweep stands in. Only while edges are left.
inline ChainEdge current_edge(const OutlineStore& store, const Chain& chain)
{
    return edge_of(store, chain, chain.passed);
}

}
