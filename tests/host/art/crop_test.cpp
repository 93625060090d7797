#include "host/art/animation/ease.hpp"
#include "host/art/prepare/prepare.hpp"
#include "host/geometry/shape.hpp"
#include "host/program/failure.hpp"
#include "tests/host/art/random_document.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using art::Channel;
using art::Document;
using art::Drawing;
using art::EaseKind;
using art::Key;
using art::Node;
using art::Shape;

Document of(Node node)
{
    Document document;
    document.width = document.height = 100;
    document.frames = 10;
    document.nodes.push_back(std::move(node));
    return document;
}

Drawing square(double size) { return {{scene::rectangle({0, 0}, size, size, 0)}}; }

}

TEST_CASE("a cropped animation goes as before within the scene, with keys in it only")
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        RandomArt random{seed};
        const Channel before = random.channel(-15, 25, 100);
        Document document = of(Node{});
        document.nodes[0].transform.x = before;
        art::Losses losses;
        art::crop(document, losses);
        const Channel& after = document.nodes[0].transform.x;
        CHECK(after.keys.front().time >= 0);
        CHECK(after.keys.back().time <= 10);
        for (int i = 0; i <= 1000; ++i) {
            const double time = i / 100.0;
            CHECK(std::abs(after.at(time) - before.at(time)) < 0.01);
        }
        for (std::size_t i = 1; i < after.keys.size(); ++i)
            CHECK(after.keys[i - 1].time < after.keys[i].time);
        CHECK(losses.empty());
    }
}

TEST_CASE("drawings, colours, bones and what lies deep inside are cropped")
{
    Shape shape;
    shape.drawing = art::Animated<Drawing>{{{-10, square(10), {}}, {20, square(40), {}}}};
    shape.fill.emplace().colour = art::Animated<art::Rgb>{{{-10, {0, 0, 0}, {}}, {30, {1, 1, 1}, {}}}};
    shape.stroke.emplace().width = Channel{{{-10, 0, {}}, {30, 4, {}}}};
    art::Group group;
    group.nodes.push_back(Node{});
    group.nodes.back().content = shape;
    Node outer;
    outer.content = group;
    Document document = of(outer);
    document.rigs.push_back({"rig", {art::Bone{}}});
    document.rigs[0].bones[0].length = Channel{{{-10, 0, {}}, {30, 4, {}}}};
    art::Losses losses;
    art::crop(document, losses);

    const auto& inner = std::get<Shape>(std::get<art::Group>(document.nodes[0].content).nodes[0].content);
    CHECK(inner.drawing.keys.front() == Key<Drawing>{0, square(20), {}});
    CHECK(inner.drawing.keys.back() == Key<Drawing>{10, square(30), {}});
    CHECK(inner.fill->colour.keys.front() == Key<art::Rgb>{0, {0.25, 0.25, 0.25}, {}});
    CHECK(inner.stroke->width.keys.back() == Key<double>{10, 2, {}});
    CHECK(document.rigs[0].bones[0].length->keys.front() == Key<double>{0, 1, {}});
    CHECK(losses.empty());
}

TEST_CASE("what happens only outside of the scene is a constant")
{
    Document document = of(Node{});
    document.nodes[0].transform.x = Channel{{{-9, 1, {}}, {-3, 2, {}}}};
    document.nodes[0].transform.y = Channel{{{12, 1, {}}, {15, 2, {}}}};
    document.nodes[0].transform.rotate = Channel{{{-5, 3, {EaseKind::hold}}, {15, 2, {}}}};
    art::Losses losses;
    art::crop(document, losses);
    CHECK(document.nodes[0].transform.x.at(4) == 2);
    CHECK(document.nodes[0].transform.x.is_still());
    CHECK(document.nodes[0].transform.y.at(4) == 1);
    CHECK(document.nodes[0].transform.rotate.at(0) == 3);
    CHECK(document.nodes[0].transform.rotate.at(10) == 3);
}

TEST_CASE("drawings of different form keep their way to a key behind the end")
{
    Shape shape;
    const Drawing triangle{{scene::polyline(std::vector<scene::Vec2>{{0, 0}, {9, 0}, {0, 9}}, true)}};
    shape.drawing = art::Animated<Drawing>{{{-4, triangle, {}}, {5, square(10), {}}, {20, triangle, {}}}};
    Node node;
    node.name = "morph";
    node.content = shape;
    Document document = of(node);
    art::Losses losses;
    art::crop(document, losses);
    const auto& keys = std::get<Shape>(document.nodes[0].content).drawing.keys;
    REQUIRE(keys.size() == 3);
    CHECK(keys[0].time == 0);
    CHECK(keys[2].time == 20);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].layer == "morph");
}

TEST_CASE("times when nodes are seen are cropped")
{
    Document document = of(Node{});
    document.nodes[0].shown = {{-9, -2}, {-1, 3}, {4, 5}, {8, 10}, {10, 20}};
    art::Losses losses;
    Document once = document;
    once.loop = Loop::once;
    art::crop(document, losses);
    const auto& shown = document.nodes[0].shown;
    REQUIRE(shown.size() == 3);
    CHECK(std::isinf(shown[0].from));
    CHECK(shown[0].to == 3);
    CHECK(shown[1] == art::Span{4, 5});
    CHECK(shown[2].from == 8);
    CHECK(std::isinf(shown[2].to));
    art::crop(once, losses);
    REQUIRE(once.nodes[0].shown.size() == 4);
    CHECK(once.nodes[0].shown[2].to == 10);
    CHECK(once.nodes[0].shown[3].from == 10);
}

TEST_CASE("markers outside of the scene are told")
{
    Document document = of(Node{});
    document.markers = {
        {"before", -5, 2}, {"in", 3, 0}, {"over", 8, 10}, {"at the end", 10, 0}, {"behind", 11, 0}};
    art::Losses losses;
    art::crop(document, losses);
    REQUIRE(document.markers.size() == 3);
    CHECK(document.markers[1].duration == 2);
    CHECK(losses.list().size() == 2);
}

TEST_CASE("nodes that lie too deep in each other are refused")
{
    Node node;
    for (int i = 0; i < 100; ++i) {
        art::Group group;
        group.nodes.push_back(std::move(node));
        node = Node{};
        node.content = std::move(group);
    }
    Document document = of(std::move(node));
    art::Losses losses;
    CHECK_THROWS_AS(art::crop(document, losses), Failure);
}

}
