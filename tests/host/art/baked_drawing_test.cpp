#include "host/art/animation/baked_drawing.hpp"

#include "host/art/geometry/affine.hpp"
#include "host/geometry/shape.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {
namespace {

using art::Animated;
using art::Baking;
using art::Drawing;
using scene::Vec2;

constexpr double tolerance = 1.0 / 32;

double apart(const scene::Outline& left, const scene::Outline& right)
{
    double max = distance(left.from, right.from);
    for (std::size_t i = 0; i < left.curves.size(); ++i) {
        max = std::max(max, distance(left.curves[i].to, right.curves[i].to));
        if (right.curves[i].cubic)
            max = std::max({max, distance(left.curves[i].c1, right.curves[i].c1),
                            distance(left.curves[i].c2, right.curves[i].c2)});
    }
    return max;
}

/// A rounded rectangle that swings about the canvas' corner.
Drawing swinging(double time)
{
    const double phase = 2 * std::numbers::pi * time / 40;
    const art::Affine place =
        art::turned(80 * std::sin(phase)) * art::grown(1, 1 + 0.3 * std::sin(3 * phase));
    return {{place.of(scene::rectangle({100, 20}, 60, 30, 8))}};
}

}

TEST_CASE("a baked drawing is within the tolerance at every time")
{
    const auto baked = art::baked_drawing(swinging, {0, 40, {}, tolerance});
    CHECK(baked.keys.front().time == 0);
    CHECK(baked.keys.back().time == 40);
    double max = 0;
    for (int i = 0; i <= 40 * 997; ++i) {
        const double time = i / 997.0;
        max = std::max(max, apart(baked.at(time).outlines[0], swinging(time).outlines[0]));
    }
    CHECK(max <= tolerance);
    CHECK(max > tolerance / 8); // else it has more keys than it needs
}

TEST_CASE("baking keeps few keys of what goes straight or stands still")
{
    const auto ramp = [](double time) { return time < 10 ? 0 : std::min(time - 10, 20.0); };
    const auto baked = art::baked_channel(ramp, {0, 60, {10, 30}, 0.01});
    REQUIRE(baked.keys.size() == 3);
    CHECK(baked.keys[1].time == doctest::Approx(10).epsilon(0.001));
    CHECK(baked.keys[2].time == doctest::Approx(30).epsilon(0.001));
    CHECK(art::baked_channel([](double) { return 7; }, {0, 60, {10, 30}, 0.01}).is_still());
    CHECK(art::baked_channel([](double) { return 7; }, {5, 5, {}, 0.01}).is_still());
}

TEST_CASE("a jump is baked as a jump")
{
    const auto stairs = [](double time) { return std::floor(time / 10); };
    const auto baked = art::baked_channel(stairs, {0, 25, {20, 10, 10, -3, 99}, 0.01});
    REQUIRE(baked.keys.size() == 3);
    for (const double time : {0.0, 5.0, 9.9999, 10.0, 15.0, 19.9999, 20.0, 25.0})
        CHECK(baked.at(time) == stairs(time));

    const auto saw = [](double time) { return time - 10 * std::floor(time / 10); };
    const auto teeth = art::baked_channel(saw, {0, 25, {10, 20}, 0.01});
    CHECK(teeth.keys.size() == 6);
    for (const double time : {0.0, 5.0, 9.99, 10.0, 10.01, 15.0, 19.99, 20.0, 25.0})
        CHECK(teeth.at(time) == doctest::Approx(saw(time)).epsilon(0.0002));
}

TEST_CASE("a jump at the end of what is baked is there")
{
    const auto baked = art::baked_channel([](double time) { return time < 8 ? 1 : 2; }, {0, 8, {8}, 0.01});
    CHECK(baked.at(7.99) == 1);
    CHECK(baked.at(8) == 2);
}

TEST_CASE("fast turns are asked for more often than every quarter of a frame")
{
    const auto turning = [](double time) { return Vec2{100 * std::cos(2 * time), 100 * std::sin(2 * time)}; };
    const auto baked = art::baked_place(turning, {0, 4, {}, tolerance});
    for (int i = 0; i <= 4000; ++i) {
        const double time = i / 1000.0;
        CHECK(distance({baked.x.at(time), baked.y.at(time)}, turning(time)) <= tolerance);
    }
}

TEST_CASE("lines that are lines at all times stay lines when they are baked")
{
    const auto bending = [](double time) {
        scene::Outline outline = scene::polyline(std::vector<Vec2>{{0, 0}, {30, 0}, {30, 30}}, false);
        if (time > 3)
            outline.curves[1] = scene::cubic_to({30, 10}, {30 + time - 3, 20}, {30, 30});
        return Drawing{{outline}};
    };
    const auto baked = art::baked_drawing(bending, {0, 9, {}, tolerance});
    for (const auto& key : baked.keys) {
        CHECK(!key.value.outlines[0].curves[0].cubic);
        CHECK(key.value.outlines[0].curves[1].cubic);
    }
    CHECK(baked.at(9).outlines[0].curves[1].c2.x == doctest::Approx(36));
    CHECK(baked.at(0).outlines[0].curves[1].c2.x == doctest::Approx(30));
}

TEST_CASE("baking is bounded by a number of keys")
{
    const auto noise = [](double time) { return std::fmod(time * 7919, 13); };
    CHECK_THROWS_AS(art::baked_channel(noise, {0, 100, {}, 0.01, 50}), Failure);
    CHECK(art::baked_channel(noise, {0, 1e5, {}, 30, 50}).keys.size() <= 50);
}

}
