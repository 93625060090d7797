#include "host/geometry/mesh.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace kfast::scene {
namespace {

std::vector<Edge> without_duplicates(const std::vector<Edge>& edges)
{
    std::set<std::pair<std::size_t, std::size_t>> known;
    std::vector<Edge> once;
    for (const Edge& edge : edges)
        if (known.insert(std::minmax(edge.from, edge.to)).second)
            once.push_back(edge);
    return once;
}

}

Mesh cuboid(const Vec3& corner, double width, double height, double depth)
{
    Mesh mesh;
    for (const double z : {corner.z, corner.z + depth}) { // each end clockwise from the upper left
        mesh.vertices.push_back({corner.x, corner.y, z});
        mesh.vertices.push_back({corner.x + width, corner.y, z});
        mesh.vertices.push_back({corner.x + width, corner.y + height, z});
        mesh.vertices.push_back({corner.x, corner.y + height, z});
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        mesh.edges.insert(mesh.edges.end(), {{i, next}, {4 + i, 4 + next}, {i, 4 + i}});
    }
    return mesh;
}

std::vector<Wire> wires_of(const Mesh& mesh)
{
    std::vector<Wire> wires;
    for (const Trail& trail : edge_trails(mesh.vertices.size(), without_duplicates(mesh.edges))) {
        Wire& wire = wires.emplace_back();
        for (const std::size_t vertex : trail)
            wire.push_back(mesh.vertices[vertex]);
    }
    return wires;
}

}
