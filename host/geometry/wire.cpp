#include "host/geometry/wire.hpp"

#include "host/geometry/drawing.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace kfast::scene {

namespace {

Segment line_segment_to(Point to) { return {.cubic = false, .c1 = {}, .c2 = {}, .to = to}; }

}

bool in_range(const Wire& wire)
{
    return std::ranges::all_of(
        wire, [](const Vec3& spot) { return in_range(spot.x) && in_range(spot.y) && in_range(spot.z); });
}

WireStroke quantized(const Wire& wire)
{
    const auto flat = [](const Vec3& spot) { return Point{to_sixteenths(spot.x), to_sixteenths(spot.y)}; };
    const auto depth = [](const Vec3& spot) { return Point{to_sixteenths(spot.z), 0}; };
    WireStroke stroke{.flat = {flat(wire.front()), {}}, .depths = {depth(wire.front()), {}}};
    for (auto spot = wire.begin() + 1; spot != wire.end(); ++spot) {
        stroke.flat.segments.push_back(line_segment_to(flat(*spot)));
        stroke.depths.segments.push_back(line_segment_to(depth(*spot)));
    }
    return stroke;
}

namespace {

/// Hierholzer's algorithm. Vertices with an odd number of edges are joined in pairs by added edges, so that
/// every part has a closed walk along all of its edges, which then is cut where it follows an added one.
class TrailFinder {
public:
    TrailFinder(std::size_t vertices, std::span<const Edge> edges)
        : edges_{edges.begin(), edges.end()},
          drawn_{edges.size()},
          edges_at_(vertices),
          next_at_(vertices),
          is_walked_(edges.size())
    {
        for (std::size_t edge = 0; edge < drawn_; ++edge)
            enter(edge);
    }

    std::vector<Trail> find()
    {
        join_odd_vertices();
        std::vector<Trail> trails;
        for (std::size_t vertex = 0; vertex < edges_at_.size(); ++vertex)
            if (next_edge(vertex))
                cut(closed_walk(vertex), trails);
        return trails;
    }

private:
    struct Step {
        std::size_t vertex;
        std::size_t edge; ///< to the vertex of the next step; meaningless in the last one
    };

    void enter(std::size_t edge)
    {
        edges_at_[edges_[edge].from].push_back(edge);
        edges_at_[edges_[edge].to].push_back(edge);
    }

    void join_odd_vertices()
    {
        std::vector<bool> is_seen(edges_at_.size());
        for (std::size_t vertex = 0; vertex < edges_at_.size(); ++vertex) {
            const std::vector<std::size_t> odd = odd_vertices_of_part(vertex, is_seen);
            for (std::size_t i = 0; i < odd.size(); i += 2) { // there is always an even number of them
                edges_.push_back({odd[i], odd[i + 1]});
                is_walked_.push_back(false);
                enter(edges_.size() - 1);
            }
        }
    }

    /// Those of the component of `vertex`; none if it has been visited.
    std::vector<std::size_t> odd_vertices_of_part(std::size_t vertex, std::vector<bool>& is_seen) const
    {
        std::vector<std::size_t> odd;
        std::vector<std::size_t> to_see{vertex};
        while (!to_see.empty()) {
            const std::size_t at = to_see.back();
            to_see.pop_back();
            if (is_seen[at])
                continue;
            is_seen[at] = true;
            if (edges_at_[at].size() % 2 != 0)
                odd.push_back(at);
            for (const std::size_t edge : edges_at_[at])
                to_see.push_back(other_end(edge, at));
        }
        std::ranges::sort(odd);
        return odd;
    }

    std::size_t other_end(std::size_t edge, std::size_t vertex) const
    {
        return edges_[edge].from == vertex ? edges_[edge].to : edges_[edge].from;
    }

    /// The next edge that has not been walked.
    std::optional<std::size_t> next_edge(std::size_t vertex)
    {
        for (std::size_t& next = next_at_[vertex]; next < edges_at_[vertex].size(); ++next)
            if (!is_walked_[edges_at_[vertex][next]])
                return edges_at_[vertex][next];
        return std::nullopt;
    }

    /// A closed walk along all edges of the component of `start`.
    std::vector<Step> closed_walk(std::size_t start)
    {
        std::vector<Step> walk;
        std::vector<Step> ahead{{start, 0}};
        while (!ahead.empty()) {
            const std::size_t vertex = ahead.back().vertex;
            if (const auto edge = next_edge(vertex)) {
                is_walked_[*edge] = true;
                ahead.push_back({other_end(*edge, vertex), *edge});
            } else {
                walk.push_back(ahead.back());
                ahead.pop_back();
            }
        }
        return walk;
    }

    bool is_added(const Step& step) const { return step.edge >= drawn_; }

    void cut(std::vector<Step> walk, std::vector<Trail>& trails) const
    {
        walk.pop_back(); // the first vertex again
        const auto added = std::ranges::find_if(walk, [this](const Step& step) { return is_added(step); });
        const bool is_whole = added == walk.end();
        if (!is_whole)
            std::rotate(walk.begin(), added + 1, walk.end());
        Trail trail;
        for (const Step& step : walk) {
            trail.push_back(step.vertex);
            if (is_added(step))
                trails.push_back(std::exchange(trail, {}));
        }
        if (!is_whole)
            return;
        trail.push_back(trail.front());
        trails.push_back(std::move(trail));
    }

    std::vector<Edge> edges_;
    std::size_t drawn_;                              ///< edges; those after them are added
    std::vector<std::vector<std::size_t>> edges_at_; ///< of each vertex
    std::vector<std::size_t> next_at_;               ///< of these, the first that may be unwalked
    std::vector<bool> is_walked_;
};

}

std::vector<Trail> edge_trails(std::size_t vertices, std::span<const Edge> edges)
{
    return TrailFinder{vertices, edges}.find();
}

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
