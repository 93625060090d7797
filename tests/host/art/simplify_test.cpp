#include "host/art/prepare/prepare.hpp"
#include "host/geometry/shape.hpp"
#include "tests/host/art/art_parts.hpp"
#include "tests/host/art/canvas_drawing.hpp"
#include "tests/host/art/crowded_art.hpp"
#include "tests/host/art/random_document.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using art::Channel;
using art::Document;
using art::Drawing;
using art::Group;
using art::Key;
using art::Node;
using art::Shape;
using scene::Vec2;

constexpr double tolerance = 1.0 / 32;

std::size_t count_keys(const std::vector<Node>& nodes)
{
    std::size_t count = 0;
    for (const Node& node : nodes) {
        const auto& t = node.transform;
        for (const Channel* channel :
             {&t.anchor_x, &t.anchor_y, &t.x, &t.y, &t.scale_x, &t.scale_y, &t.rotate})
            count += channel->keys.size();
        if (const auto* group = std::get_if<Group>(&node.content))
            count += count_keys(group->nodes);
        else
            count += std::get<Shape>(node.content).drawing.keys.size();
    }
    return count;
}

/// Of control points: their number is the same, where nothing is merged.
double farthest_control(const Drawing& left, const Drawing& right)
{
    double max = 0;
    for (std::size_t i = 0; i < left.outlines.size(); ++i)
        for (std::size_t j = 0; j < left.outlines[i].curves.size(); ++j) {
            const auto& one = left.outlines[i].curves[j];
            const auto& other = right.outlines[i].curves[j];
            max = std::max(
                {max, distance(one.c1, other.c1), distance(one.c2, other.c2), distance(one.to, other.to)});
        }
    return max;
}

double worst(const Document& before, const Document& after, RandomArt& random, int times)
{
    double max = 0;
    for (int i = 0; i < times; ++i) {
        const double time = random.number(-1, 41);
        const CanvasDrawings left{before, time};
        const CanvasDrawings right{after, time};
        for (const auto& [name, drawing] : left.drawings())
            max = std::max(max, farthest_control(drawing, right.drawings().at(name)));
    }
    return max;
}

}

TEST_CASE("simplification moves nothing on the canvas by more than the tolerance")
{
    std::size_t before = 0;
    std::size_t after = 0;
    double max = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(60)); ++seed) {
        const Document given = CrowdedArt{seed, false}.document();
        Document simple = given;
        art::simplify(simple, tolerance);
        RandomArt random{seed + 1000};
        max = std::max(max, worst(given, simple, random, 150));
        before += count_keys(given.nodes);
        after += count_keys(simple.nodes);
    }
    CHECK(max <= tolerance);
    CHECK(max > tolerance / 64);
    CHECK(after * 4 < before * 3);
}

TEST_CASE("simplification in space moves nothing by more than the tolerance")
{
    double max = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(40)); ++seed) {
        const Document given = CrowdedArt{seed, true}.document();
        Document simple = given;
        art::simplify(simple, tolerance);
        RandomArt random{seed + 1000};
        max = std::max(max, worst(given, simple, random, 150));
    }
    CHECK(max <= tolerance);
    CHECK(max > 0);
}

TEST_CASE("what a group enlarges is simplified less")
{
    scene::Outline outline{{0, 0}, {}, true};
    for (const Vec2 to : {Vec2{10, 0.02}, {20, 0}, {20, 20}})
        outline.curves.push_back(scene::line_to(to));
    for (const double factor : {1.0, 4.0}) {
        Node group;
        group.transform.scale_x = factor;
        group.content = Group{{node_of(filled(Drawing{{outline}}))}};
        Document document = document_of(std::move(group));
        art::simplify(document, tolerance);
        const Node& inner = std::get<Group>(document.nodes[0].content).nodes[0];
        const auto& curves = std::get<Shape>(inner.content).drawing.value().outlines[0].curves;
        CHECK(curves.size() == (factor > 1 ? 3 : 2));
    }
}

TEST_CASE("what several channels may be off adds up to no more than the tolerance")
{
    const double off = 0.6 * tolerance;
    const Channel bump{{{0, 0, {}}, {5, 5 + off, {}}, {10, 10, {}}}};
    Node outer;
    outer.transform.x = bump;
    outer.content = Group{{node_of(filled(Drawing{{scene::rectangle({0, 0}, 9, 9, 0)}}))}};
    Node& inner = std::get<Group>(outer.content).nodes[0];
    inner.name = "square";
    inner.transform.x = bump;
    const Document given = document_of(outer);
    Document simple = given;
    art::simplify(simple, tolerance);
    RandomArt random{1};
    CHECK(worst(given, simple, random, 200) <= tolerance);

    Document alone = document_of(node_of(filled(Drawing{{scene::rectangle({0, 0}, 9, 9, 0)}})));
    alone.nodes[0].transform.x = Channel{{{0, 0, {}}, {5, 5 + off / 2, {}}, {10, 10, {}}}};
    art::simplify(alone, tolerance);
    CHECK(alone.nodes[0].transform.x.keys.size() == 2);
}

TEST_CASE("what comes near to the viewer is simplified less")
{
    Node node = node_of(filled(Drawing{{scene::rectangle({0, 0}, 9, 9, 0)}}));
    node.name = "square";
    node.transform.x = Channel{{{0, 0, {}}, {5, 5 + tolerance / 3, {}}, {10, 10, {}}}};
    for (const double depth : {0.0, 80.0}) {
        Document document = document_of(node);
        document.camera = 100;
        document.nodes[0].transform.z = depth;
        art::simplify(document, tolerance);
        CHECK(document.nodes[0].transform.x.keys.size() == (depth > 0 ? 3 : 2));
    }
}

TEST_CASE("neighbours of one parent keep the same transform")
{
    RandomArt random{7};
    Document document = document_of(Node{});
    document.nodes.clear();
    art::Transform transform;
    std::vector<Key<double>> keys;
    for (int i = 0; i <= 40; ++i)
        keys.push_back({1.0 * i, 30 * std::sin(0.1 * i), {}});
    transform.rotate = Channel{keys};
    for (const double size : {1.0, 90.0}) {
        Node node;
        node.parent_tag = 3;
        node.transform = transform;
        node.content = Group{{node_of(filled(Drawing{{scene::rectangle({0, 0}, size, size, 0)}}))}};
        document.nodes.push_back(std::move(node));
    }
    art::simplify(document, tolerance);
    CHECK(document.nodes[0].transform == document.nodes[1].transform);
    CHECK(document.nodes[0].transform.rotate.keys.size() < 41);
}

TEST_CASE("what is never seen is taken out")
{
    const Drawing square{{scene::rectangle({0, 0}, 9, 9, 0)}};
    const Drawing point{{scene::polyline(std::vector<Vec2>{{5, 5}, {5, 5}}, true)}};
    Document document = document_of(node_of(filled(square)));
    Node hidden = node_of(filled(square));
    hidden.shown.clear();
    Node clear = node_of(filled(square));
    clear.opacity = 0;
    Node inkless = node_of(Shape{});
    Node empty;
    empty.content = Group{{hidden, clear, inkless}};
    Shape dot;
    dot.drawing = point;
    dot.stroke.emplace().cap = Cap::round;
    Shape no_dot = dot;
    no_dot.stroke->cap = Cap::butt;
    for (const Node& node :
         {hidden, clear, inkless, empty, node_of(filled(point)), node_of(dot), node_of(no_dot)})
        document.nodes.push_back(node);
    art::simplify(document, tolerance);
    REQUIRE(document.nodes.size() == 2);
    CHECK(std::get<Shape>(document.nodes[1].content).stroke.has_value());
}

TEST_CASE("without a tolerance only what is of no use goes")
{
    Document document = document_of(node_of(filled(Drawing{{scene::ellipse({5, 5}, 4, 4)}})));
    document.nodes[0].transform.x = Channel{{{0, 1, {}}, {5, 6, {}}, {10, 11, {}}, {20, 5, {}}}};
    document.nodes[0].transform.y = Channel{{{0, 1, {}}, {5, 1, {}}}};
    art::simplify(document, 0);
    CHECK(document.nodes[0].transform.x == Channel{{{0, 1, {}}, {10, 11, {}}, {20, 5, {}}}});
    CHECK(document.nodes[0].transform.y == Channel{1});
}

}
