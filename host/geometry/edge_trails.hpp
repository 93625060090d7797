#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kfast::scene {

/// Two different vertices.
struct Edge {
    std::size_t from = 0;
    std::size_t to = 0;
};

/// Vertices, each joined to the next by an edge.
using Trail = std::vector<std::size_t>;

/// The fewest trails that run along each of `edges` once: of each connected part, one that comes back to its
/// beginning, or half as many as there are vertices with an odd number of edges. The vertices of all edges
/// are less than `vertices`. Where edges lead is all that matters: equal ones give equal trails.
std::vector<Trail> edge_trails(std::size_t vertices, std::span<const Edge> edges);

}
