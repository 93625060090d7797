#include "host/art/prepare/prepare.hpp"

#include "host/art/geometry/curves.hpp"
#include "host/geometry/shape.hpp"
#include "tests/host/art/art_parts.hpp"
#include "tests/host/art/drawn_distance.hpp"
#include "tests/host/art/random_document.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {
namespace {

using art::Animated;
using art::CubicPiece;
using art::Drawing;
using art::Shape;
using scene::Outline;
using scene::Vec2;

constexpr double tolerance = 1.0 / 32;

Shape stroked(Animated<Drawing> drawing, double width, Join join)
{
    Shape shape;
    shape.drawing = std::move(drawing);
    shape.stroke.emplace();
    shape.stroke->width = width;
    shape.stroke->join = join;
    return shape;
}

const Outline& first(const Shape& shape) { return shape.drawing.keys[0].value.outlines[0]; }

/// The curves of an outline, each divided at the same parameters in all keys.
Outline divided(const Outline& outline, const std::vector<double>& at, RandomArt& random, double noise)
{
    Outline result{outline.from, {}, outline.closed};
    Vec2 from = outline.from;
    const auto shaken = [&](Vec2 spot) { return spot + random.spot(noise); };
    for (const scene::Curve& given : outline.curves) {
        const scene::Curve curve = art::as_cubic(from, given);
        const CubicPiece whole{{from, curve.c1, curve.c2, curve.to}};
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const CubicPiece piece = whole.between(at[i], at[i + 1]);
            const bool last = i + 2 == at.size();
            const Vec2 to = last ? curve.to : shaken(piece.points[3]);
            result.curves.push_back(
                given.cubic ? scene::cubic_to(shaken(piece.points[1]), shaken(piece.points[2]), to)
                            : scene::line_to(to));
        }
        from = curve.to;
    }
    return result;
}

std::vector<double> cuts(RandomArt& random)
{
    std::vector<double> at{0};
    const int count = random.integer(1, 4);
    for (int i = 1; i < count; ++i)
        at.push_back(random.number(i + 0.0, i + 0.8) / count);
    at.push_back(1);
    return at;
}

/// Smooth somewhere, with corners elsewhere.
Outline wild(RandomArt& random, const std::vector<bool>& cubic)
{
    Outline outline{random.spot(60), {}, false};
    Vec2 direction = random.spot(20);
    for (const bool curved : cubic) {
        const Vec2 from = outline.curves.empty() ? outline.from : outline.curves.back().to;
        const Vec2 to = from + random.spot(50);
        const Vec2 arrival = random.spot(20);
        outline.curves.push_back(curved ? scene::cubic_to(from + direction, to - arrival, to)
                                        : scene::line_to(to));
        direction = curved && random.chance(0.7) ? arrival : random.spot(20);
    }
    return outline;
}

std::size_t curves_of(const Shape& shape) { return first(shape).curves.size(); }

}

TEST_CASE("merging moves nothing by more than the tolerance, at any time")
{
    std::size_t before = 0;
    std::size_t after = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(240)); ++seed) {
        RandomArt random{seed};
        const double noise = random.number(0, 0.02);
        std::vector<bool> cubic;
        for (int i = random.integer(1, 4); i > 0; --i)
            cubic.push_back(random.chance(0.7));
        const auto at = cuts(random);
        std::vector<art::Key<Drawing>> keys;
        for (int key = random.integer(1, 4); key > 0; --key)
            keys.push_back({10.0 * static_cast<double>(keys.size()),
                            {{divided(wild(random, cubic), at, random, noise)}},
                            random.ease()});
        const Shape given = seed % 2 == 0 ? filled(Animated<Drawing>{keys})
                                          : stroked(Animated<Drawing>{keys}, 3, Join::round);
        Shape merged = given;
        art::merge_curves(merged, tolerance);
        before += curves_of(given);
        after += curves_of(merged);
        for (int i = 0; i < 12; ++i) {
            const double time = random.number(0, 30);
            CHECK(drawn_distance(given.drawing.at(time), merged.drawing.at(time)) <= tolerance + 1e-3);
        }
    }
    CHECK(after * 3 < before * 2);
}

TEST_CASE("what was divided becomes one curve again, in all keys")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        RandomArt random{seed};
        const auto at = cuts(random);
        constexpr int count = 3;
        std::vector<art::Key<Drawing>> keys;
        keys.reserve(count);
        for (int key = 0; key < count; ++key)
            keys.push_back({10.0 * key, {{divided(wild(random, {true}), at, random, 0)}}, {}});
        Shape shape = filled(Animated<Drawing>{keys});
        art::merge_curves(shape, tolerance);
        CHECK(curves_of(shape) == 1);
        for (const auto& key : shape.drawing.keys)
            CHECK(key.value.outlines[0].curves.size() == 1);
    }
}

TEST_CASE("lines in a row become one, many short ones a curve")
{
    Outline outline{{0, 0}, {}, true};
    for (const Vec2 to : {Vec2{10, 0.01}, {25, 0}, {50, 0}, {50, 10}, {50, 40}})
        outline.curves.push_back(scene::line_to(to));
    Shape shape = filled(Drawing{{outline}});
    art::merge_curves(shape, tolerance);
    CHECK(curves_of(shape) == 2);

    Outline round{{100, 0}, {}, false};
    for (int i = 1; i <= 200; ++i) {
        const double angle = std::numbers::pi * i / 200;
        round.curves.push_back(scene::line_to({100 * std::cos(angle), 100 * std::sin(angle)}));
    }
    const Shape given = filled(Drawing{{round}});
    Shape arc = given;
    art::merge_curves(arc, tolerance);
    CHECK(curves_of(arc) < 5);
    CHECK(drawn_distance(given.drawing.value(), arc.drawing.value()) <= tolerance);
}

TEST_CASE("a curve that is straight becomes a line, if it is so in all keys")
{
    const auto straight = [](Vec2 to, double first, double second) {
        return Drawing{{Outline{{0, 0}, {scene::cubic_to(first * to, second * to, to)}, false}}};
    };
    Shape still = filled(straight({40, 30}, 0.1, 0.7));
    art::merge_curves(still, tolerance);
    CHECK(!first(still).curves[0].cubic);
    Shape same = filled(
        Animated<Drawing>{{{0, straight({40, 30}, 0.1, 0.7), {}}, {9, straight({0, 50}, 0.1, 0.7), {}}}});
    art::merge_curves(same, tolerance);
    CHECK(!first(same).curves[0].cubic);
    // Both are straight, but what is between them is not.
    Shape other = filled(
        Animated<Drawing>{{{0, straight({40, 30}, 0.1, 0.7), {}}, {9, straight({0, 50}, 0.5, 0.9), {}}}});
    art::merge_curves(other, tolerance);
    CHECK(first(other).curves[0].cubic);
    Shape beyond = filled(straight({40, 30}, 0.1, 1.5));
    art::merge_curves(beyond, tolerance);
    CHECK(first(beyond).curves[0].cubic);
}

TEST_CASE("segments of no length in all keys vanish, those of some length in one stay")
{
    const auto with = [](Vec2 third) {
        return Drawing{
            {scene::polyline(std::vector<Vec2>{{0, 0}, {9, 0}, {9, 0}, {9, 0}, third, {0, 9}}, true)}};
    };
    Shape shape = filled(Animated<Drawing>{{{0, with({9, 0}), {}}, {9, with({12, 5}), {}}}});
    art::merge_curves(shape, tolerance);
    CHECK(curves_of(shape) == 3);
    Shape still = filled(with({9, 0}));
    art::merge_curves(still, tolerance);
    CHECK(curves_of(still) == 2);
}

TEST_CASE("the small zigzag of a wide line with miters keeps its tips")
{
    Outline zigzag{{0, 0}, {}, false};
    for (int i = 1; i <= 10; ++i)
        zigzag.curves.push_back(scene::line_to({i * 0.1, i % 2 * 0.02}));
    zigzag.curves.push_back(scene::line_to({50, 0}));
    Shape round = stroked(Drawing{{zigzag}}, 8, Join::round);
    round.stroke->cap = Cap::round;
    art::merge_curves(round, tolerance);
    CHECK(curves_of(round) < 11);
    Shape mitred = stroked(Drawing{{zigzag}}, 8, Join::miter);
    art::merge_curves(mitred, tolerance);
    CHECK(curves_of(mitred) >= 10);

    Outline notch{{0, 0}, {}, false};
    for (const Vec2 to : {Vec2{5, 0}, {5.1, 0.015}, {5.2, -0.015}, {5.3, 0}, {10, 0}})
        notch.curves.push_back(scene::line_to(to));
    Shape smooth = filled(Drawing{{notch}});
    art::merge_curves(smooth, tolerance);
    CHECK(curves_of(smooth) == 1);
    Shape tipped = stroked(Drawing{{notch}}, 8, Join::miter);
    art::merge_curves(tipped, tolerance);
    CHECK(curves_of(tipped) == 5);
}

TEST_CASE("merging keeps the angles of corners")
{
    // The first arm is nearly straight, so that one line is near enough to it; the corner's tip would move.
    Outline corner{{0, 0}, {}, false};
    for (const Vec2 to : {Vec2{20, 0}, {39, 0}, {40, 0.02}, {0, 12}})
        corner.curves.push_back(scene::line_to(to));
    Shape fill = filled(Drawing{{corner}});
    art::merge_curves(fill, tolerance);
    CHECK(curves_of(fill) == 2);
    Shape wide = stroked(Drawing{{corner}}, 6, Join::miter);
    art::merge_curves(wide, tolerance);
    CHECK(curves_of(wide) == 3);
}

TEST_CASE("drawings of different forms, and those of bones, are not merged")
{
    const Drawing three{{scene::polyline(std::vector<Vec2>{{0, 0}, {5, 0}, {9, 0}, {9, 9}}, true)}};
    const Drawing two{{scene::polyline(std::vector<Vec2>{{0, 0}, {9, 0}, {9, 9}}, true)}};
    const Shape given = filled(Animated<Drawing>{{{0, three, {}}, {9, two, {}}}});
    Shape merged = given;
    art::merge_curves(merged, tolerance);
    CHECK(merged == given);
    Shape skinned = filled(three);
    skinned.skin.emplace();
    art::merge_curves(skinned, tolerance);
    CHECK(curves_of(skinned) == 3);
}

TEST_CASE("a hundred thousand points are merged at once")
{
    Outline outline{{0, 0}, {}, false};
    for (int i = 1; i <= 100'000; ++i)
        outline.curves.push_back(scene::line_to({i * 0.02, 50 * std::sin(i * 0.001)}));
    Shape shape = filled(Drawing{{outline}});
    art::merge_curves(shape, tolerance);
    CHECK(curves_of(shape) < 300);
    Outline noise{{0, 0}, {}, false};
    RandomArt random{1};
    for (int i = 1; i <= 100'000; ++i)
        noise.curves.push_back(scene::line_to({i * 0.02, random.number(0, 0.008)}));
    Shape flat = filled(Drawing{{noise}});
    art::merge_curves(flat, tolerance);
    CHECK(curves_of(flat) < 50'000);
}

}
