#include "host/geometry/wire.hpp"

#include "tests/rounds.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace kfast::test {
namespace {

using scene::Edge;
using scene::Trail;
using Ends = std::pair<std::size_t, std::size_t>;

Ends ends_of(std::size_t a, std::size_t b) { return std::minmax(a, b); }

std::multiset<Ends> walked(const std::vector<Trail>& trails)
{
    std::multiset<Ends> edges;
    for (const Trail& trail : trails)
        for (std::size_t i = 1; i < trail.size(); ++i)
            edges.insert(ends_of(trail[i - 1], trail[i]));
    return edges;
}

/// By colouring parts, and counting what is odd in each of them.
std::size_t fewest_trails(std::size_t vertices, const std::vector<Edge>& edges)
{
    std::vector<std::size_t> part(vertices);
    std::iota(part.begin(), part.end(), 0U);
    for (std::size_t round = 0; round < vertices; ++round)
        for (const Edge& edge : edges)
            part[edge.from] = part[edge.to] = std::min(part[edge.from], part[edge.to]);
    std::vector<std::size_t> degree(vertices);
    for (const Edge& edge : edges) {
        ++degree[edge.from];
        ++degree[edge.to];
    }
    std::map<std::size_t, std::size_t> odd;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        if (degree[vertex] != 0)
            odd[part[vertex]] += degree[vertex] % 2;
    std::size_t trails = 0;
    for (const auto& [first, count] : odd)
        trails += std::max<std::size_t>(count / 2, 1);
    return trails;
}

}

TEST_CASE("a triangle is one closed trail, a cross two")
{
    const std::vector<Edge> triangle{{0, 1}, {1, 2}, {2, 0}};
    const auto trails = scene::edge_trails(3, triangle);
    REQUIRE(trails.size() == 1);
    CHECK(trails[0].size() == 4);
    CHECK(trails[0].front() == trails[0].back());
    CHECK(scene::edge_trails(5, std::vector<Edge>{{0, 4}, {1, 4}, {2, 4}, {3, 4}}).size() == 2);
    CHECK(scene::edge_trails(5, {}).empty());
}

TEST_CASE("all edges are walked once, in the fewest trails")
{
    std::mt19937 random{9};
    for (int round = rounds(2000); round > 0; --round) {
        const std::size_t vertices = 2 + random() % 12;
        std::vector<Edge> edges;
        std::multiset<Ends> all;
        for (auto left = random() % 24; left > 0; --left) {
            const std::size_t from = random() % vertices;
            const std::size_t to = random() % vertices;
            if (from == to)
                continue;
            edges.push_back({from, to});
            all.insert(ends_of(from, to));
        }
        const auto trails = scene::edge_trails(vertices, edges);
        CHECK(walked(trails) == all);
        CHECK(trails.size() == fewest_trails(vertices, edges));
        for (const Trail& trail : trails)
            CHECK(trail.size() >= 2);
    }
}

TEST_CASE("long chains take no more time than edges")
{
    constexpr std::size_t vertices = 60'000;
    std::vector<Edge> edges;
    for (std::size_t i = 1; i < vertices; ++i)
        edges.push_back({0, i}); // a star: the centre has all edges
    CHECK(scene::edge_trails(vertices, edges).size() == vertices / 2);
}

}
