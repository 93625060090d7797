#pragma once

#include "host/geometry/edge_trails.hpp"
#include "host/geometry/wire.hpp"

#include <vector>

namespace kfast::scene {

/// Corners and the edges between them.
struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Edge> edges; ///< between these; the same one may stand several times
};

/// The twelve edges of a box. `corner` is the one with the least x, y and z.
Mesh cuboid(const Vec3& corner, double width, double height, double depth);

/// All edges, each once, in as few wires as there can be.
std::vector<Wire> wires_of(const Mesh& mesh);

}
