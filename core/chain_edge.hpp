#pragma once

#include "core/outline_store.hpp"

#include <cstdint>

namespace kfast {

/// The edge of a chain that a sweep stands in.
struct ChainEdge {
    Corner upper;
    Corner lower;

    std::int32_t height() const { return lower.y - upper.y; }

    /// x at a sub-row from its upper to its lower end, rounded down to 1/65536 px; `slope` is row_slope(),
    /// if it is a row high.
    Fixed x_at(std::int32_t subrow, std::int32_t slope) const;
};

/// How far an edge that is at least a row high moves to the right in a row, in 1/65536 px, rounded down.
std::int32_t row_slope(const ChainEdge& edge);

/// Only while edges are left: chain.passed < chain.edges.
ChainEdge current_edge(const OutlineStore& store, const Chain& chain);

}
