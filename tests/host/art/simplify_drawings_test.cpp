#include "host/art/prepare/prepare.hpp"
#include "host/geometry/shape.hpp"
#include "tests/host/art/art_parts.hpp"
#include "tests/host/art/random_document.hpp"
#include "tests/rounds.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

/// What becomes of the keys and points of drawings when art is simplified.
namespace kfast::test {
namespace {

using art::Animated;
using art::Document;
using art::Drawing;
using art::Key;
using art::Shape;
using scene::Vec2;

constexpr double tolerance = 1.0 / 32;

/// Where the edges of a line along a polygon meet outside of its corners.
std::vector<Vec2> tips(const scene::Outline& outline, double half_width)
{
    std::vector<Vec2> corners{outline.from};
    for (const scene::Curve& curve : outline.curves)
        corners.push_back(curve.to);
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 corner = corners[i];
        const auto towards = [&](Vec2 other) { return 1 / distance(corner, other) * (other - corner); };
        const Vec2 one = towards(corners[(i + 1) % corners.size()]);
        const Vec2 other = towards(corners[(i + corners.size() - 1) % corners.size()]);
        result.push_back(corner - half_width / std::abs(cross(one, other)) * (one + other));
    }
    return result;
}

}

TEST_CASE("keys of drawings that are nearly equal are equal afterwards")
{
    const auto at = [](double x) { return Drawing{{scene::ellipse({x, 5}, 4, 4)}}; };
    Shape shape = filled(Animated<Drawing>{
        {{0, at(0), {}}, {5, at(20), {}}, {9, at(20.001), {}}, {12, at(20.0005), {}}, {20, at(0.001), {}}}});
    Document document = document_of(node_of(shape));
    art::simplify(document, tolerance);
    const auto& keys = std::get<Shape>(document.nodes[0].content).drawing.keys;
    REQUIRE(keys.size() == 4);
    CHECK(keys[1].value == keys[2].value);
    CHECK(keys[0].value == keys[3].value);
}

TEST_CASE("a wide line with miters lets its drawing move less")
{
    const auto at = [](double x, double y) {
        return Drawing{{scene::polyline(std::vector<Vec2>{{0, 0}, {x, y}, {0, 9}}, true)}};
    };
    const Animated<Drawing> drawing{{{0, at(20, 4), {}}, {5, at(30, 4.005), {}}, {10, at(40, 4), {}}}};
    Shape stroke;
    stroke.drawing = drawing;
    stroke.stroke.emplace().width = 12;
    Document filled_only = document_of(node_of(filled(drawing)));
    Document lined = document_of(node_of(stroke));
    art::simplify(filled_only, tolerance);
    art::simplify(lined, tolerance);
    CHECK(std::get<Shape>(filled_only.nodes[0].content).drawing.keys.size() == 2);
    CHECK(std::get<Shape>(lined.nodes[0].content).drawing.keys.size() == 3);
}

TEST_CASE("a line that grows out of a point loses keys, for it keeps its direction")
{
    std::vector<Key<Drawing>> keys;
    for (int i = 0; i <= 20; ++i)
        keys.push_back(
            {2.0 * i, {{scene::polyline(std::vector<Vec2>{{5, 5}, {5 + 3.0 * i, 5 + 2.0 * i}}, false)}}, {}});
    Shape shape;
    shape.drawing = Animated<Drawing>{keys};
    shape.stroke.emplace().width = 9;
    Document document = document_of(node_of(shape));
    art::simplify(document, tolerance);
    CHECK(std::get<Shape>(document.nodes[0].content).drawing.keys.size() == 2);
}

TEST_CASE("the tips of a line's corners move by no more than the tolerance")
{
    std::size_t kept = 0;
    double max = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(60)); ++seed) {
        RandomArt random{seed};
        const double noise = random.number(0, 0.0003);
        std::vector<Key<Drawing>> keys;
        const std::array<Vec2, 4> corners{Vec2{0, 0}, {60, 5}, {50, 60}, {10, 40}};
        const Vec2 speed = random.spot(0.2);
        for (int i = 0; i <= 30; ++i) {
            std::vector<Vec2> spots;
            spots.reserve(corners.size());
            for (const Vec2 corner : corners)
                spots.push_back(corner + i * (0.01 * corner.x * speed) + random.spot(noise));
            keys.push_back({1.0 * i, {{scene::polyline(spots, true)}}, {}});
        }
        Shape shape;
        shape.drawing = Animated<Drawing>{keys};
        shape.stroke.emplace().width = random.number(1, 20);
        Document simple = document_of(node_of(shape));
        art::simplify(simple, tolerance);
        const auto& after = std::get<Shape>(simple.nodes[0].content).drawing;
        kept += after.keys.size();
        for (int i = 0; i < 60; ++i) {
            const double time = random.number(0, 30);
            const double half_width = shape.stroke->width.value() / 2;
            const auto before = tips(shape.drawing.at(time).outlines[0], half_width);
            const auto now = tips(after.at(time).outlines[0], half_width);
            for (std::size_t corner = 0; corner < 4; ++corner)
                max = std::max(max, distance(before[corner], now[corner]));
        }
    }
    CHECK(max <= tolerance);
    CHECK(max > 0);
    CHECK(kept < static_cast<std::size_t>(rounds(60)) * 25);
}

TEST_CASE("between changes of form, keys and segments go")
{
    const auto stroke = [](std::vector<Vec2> spots) { return Drawing{{scene::polyline(spots, false)}}; };
    const art::Ease hold{art::EaseKind::hold};
    const Animated<Drawing> drawing{{{0, stroke({{0, 0}, {10, 0}, {20, 0}}), {}},
                                     {5, stroke({{0, 0}, {10, 5}, {20, 10}}), {}},
                                     {10, stroke({{0, 0}, {10, 10}, {20, 20}}), hold},
                                     {12, stroke({{0, 0}, {20, 20}}), {}},
                                     {14, stroke({{0, 0}, {20, 20}}), {}},
                                     {16, stroke({{0, 0}, {20, 20}}), {}},
                                     {20, stroke({{0, 0}, {5, 20}, {30, 0}}), {}}}};
    Document document = document_of(node_of(filled(drawing)));
    art::simplify(document, tolerance);
    const auto& keys = std::get<Shape>(document.nodes[0].content).drawing.keys;
    REQUIRE(keys.size() == 5);
    CHECK(keys[0].value.outlines[0].curves.size() == 1);
    CHECK(keys[1].time == 10);
    CHECK(keys[1].ease == hold);
    CHECK(keys[2].time == 12);
    CHECK(keys[3].time == 16);
    CHECK(keys[4].value.outlines[0].curves.size() == 2);
}

}
