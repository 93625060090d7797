#pragma once

#include "host/geometry/drawing.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace kfast::scene {

/// A point in the space of an item before rounding, in pixels; z points at the viewer.
struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;
};

/// Straight lines through points, of which there is at least one; closed if the last one is the first.
using Wire = std::vector<Vec3>;

bool in_range(const Wire& wire);

/// A stroke with a depth for each of its points.
struct WireStroke {
    Stroke flat;
    Stroke depths; ///< see Key::depths
};

/// Rounds every point once, to the nearest 1/16 px (halves away from zero). Segments without extent stay, so
/// that the points of two wires still match.
WireStroke quantized(const Wire& wire);

/// Two different vertices.
struct Edge {
    std::size_t from = 0;
    std::size_t to = 0;
};

/// Vertices, each joined to the next by an edge.
using Trail = std::vector<std::size_t>;

/// The fewest trails that run along each of `edges` once: of each connected part, one that comes back to its
/// beginning, or half as many as there are vertices with an odd number of edges. The vertices of all edges
/// are less than `vertices`. Only the connections of edges matter: equal ones give equal trails.
std::vector<Trail> edge_trails(std::size_t vertices, std::span<const Edge> edges);

/// Corners and the edges between them.
struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Edge> edges; ///< between these; the same one may occur several times
};

/// The twelve edges of a box. `corner` is the one with the smallest x, y and z.
Mesh cuboid(const Vec3& corner, double width, double height, double depth);

/// All edges, each once, in as few wires as there can be.
std::vector<Wire> wires_of(const Mesh& mesh);

}
