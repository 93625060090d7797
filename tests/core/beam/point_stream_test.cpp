#include "tests/core/beam/plotted.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

double distance(FieldPoint a, FieldPoint b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// How far a point lies from the lines.
double distance_to(const LineStore& store, FieldPoint at)
{
    double nearest = 1e9;
    for (std::size_t number = 0; number < store.lines.size(); ++number) {
        const std::vector<FieldPoint> line = store.points(number);
        nearest = std::min(nearest, distance(at, line[0]));
        for (std::size_t i = 1; i < line.size(); ++i) {
            const double x = line[i].x - line[i - 1].x;
            const double y = line[i].y - line[i - 1].y;
            const double along = ((at.x - line[i - 1].x) * x + (at.y - line[i - 1].y) * y) / (x * x + y * y);
            const double share = std::clamp(along, 0.0, 1.0);
            nearest = std::min(
                nearest, std::hypot(line[i - 1].x + share * x - at.x, line[i - 1].y + share * y - at.y));
        }
    }
    return nearest;
}

}

TEST_CASE("lengths are not too short, and hardly too long")
{
    std::mt19937 random{7};
    for (int round = 0; round < 100'000; ++round) {
        const int bits = 1 + static_cast<int>(random() % 17);
        const auto coordinate = [&] {
            return static_cast<std::int32_t>(random() % (1U << bits)) - (1 << (bits - 1));
        };
        const std::int32_t x = coordinate();
        const FieldVector delta{x, coordinate()};
        const double length = std::hypot(delta.x, delta.y);
        REQUIRE(delta.length() >= length);
        REQUIRE(delta.length() <= length * 1.005 + 1);
    }
    CHECK(FieldVector{65535, 65535}.length() <= 92'690);
    CHECK(FieldVector{-65535, 0}.length() == 65535);
}

TEST_CASE("where there is nothing, the beam is parked, blanked")
{
    const LineStore store;
    CHECK(plotted(store, {}, plain).points == Points{{{-32768, -32768}}});
    CHECK(plotted(store, {}, galvo_profile).points == Points{{galvo_profile.park}});
}

TEST_CASE("a line is cut into even steps, and lit from its beginning to its end")
{
    LineStore store;
    store.add({{0, 0}, {0, 250}}, {1, 2, 3, 255});
    const Colour colour{1, 2, 3, 255};
    CHECK(plotted(store, store.legs(), plain).points ==
          Points{{{0, 0}}, {{0, 0}, colour}, {{0, 83}, colour}, {{0, 167}, colour}, {{0, 250}, colour}});
}

TEST_CASE("legs are followed backwards, and closed lines from where they start")
{
    LineStore store;
    store.add({{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}});
    std::vector<BeamLeg> legs = store.legs();
    const auto places = [&] {
        std::vector<FieldPoint> all;
        for (const BeamPoint& point : plotted(store, legs, plain).points) {
            CHECK(point.is_lit());
            all.push_back(point.at);
        }
        return all;
    };
    CHECK(places() == std::vector<FieldPoint>{{100, 0}, {100, 100}, {0, 100}, {0, 0}});
    legs[0].start = 2;
    CHECK(places() == std::vector<FieldPoint>{{0, 100}, {0, 0}, {100, 0}, {100, 100}});
    legs[0].is_reversed = true;
    CHECK(places() == std::vector<FieldPoint>{{100, 0}, {0, 0}, {0, 100}, {100, 100}});
}

TEST_CASE("the beam waits at corners, by how sharp they are, and at both ends")
{
    BeamProfile profile = plain;
    profile.corner_dwell = 8;
    profile.lit_dwell = 3;
    profile.arrival_dwell = 5;
    profile.leave_dwell = 2;
    profile.travel_step = 1000;
    LineStore store;
    store.add({{0, 0}, {1000, 0}, {1000, 1000}, {1000, 0}, {1900, -100}});
    const Points points = plotted(store, store.legs(), profile).points;
    CHECK(count_at(points, {0, 0}, true) == 1 + 3);
    CHECK(count_at(points, {0, 0}, false) == 1 + 5);
    CHECK(count_at(points, {1000, 1000}, true) == 1 + 8);
    CHECK(count_at(points, {1900, -100}, true) == 1 + 3);
    CHECK(count_at(points, {1900, -100}, false) == 2);
    // One right angle, and one of 96 degrees.
    CHECK(count_at(points, {1000, 0}, true) == 1 + 4 + 1 + 4);
    // 1903 units of way back.
    const auto blanked = std::ranges::count_if(points, [](const BeamPoint& p) { return !p.is_lit(); });
    CHECK(blanked == 2 + 2 + 5);
}

TEST_CASE("a turn right round is one however long the ways are")
{
    BeamProfile profile = plain;
    profile.corner_dwell = 8;
    for (const std::int16_t far : std::initializer_list<std::int16_t>{100, 32765, 32766, 32767}) {
        const auto back = static_cast<std::int16_t>(-far);
        for (const FieldPoint end :
             {FieldPoint{far, far}, FieldPoint{far, back}, FieldPoint{far, 0}, FieldPoint{back, far}}) {
            CAPTURE(end.x);
            CAPTURE(end.y);
            LineStore store;
            store.add({{0, 0}, end, {0, 0}, {0, 50}});
            CHECK(count_at(plotted(store, store.legs(), profile).points, end, true) == 1 + 8);
        }
    }
}

TEST_CASE("distance is carried over the corners of curves: pieces do not matter")
{
    LineStore fine;
    LineStore coarse;
    fine.add({{0, 0}, {33, 0}, {70, 0}, {71, 0}, {99, 0}, {180, 0}, {450, 0}});
    coarse.add({{0, 0}, {450, 0}});
    CHECK(plotted(fine, fine.legs(), plain).points == plotted(coarse, coarse.legs(), plain).points);

    LineStore circle;
    std::vector<FieldPoint> corners;
    for (int i = 0; i <= 64; ++i)
        corners.push_back(
            {static_cast<std::int16_t>(std::lround(20000 * std::cos(i * 3.14159265358979 / 32))),
             static_cast<std::int16_t>(std::lround(20000 * std::sin(i * 3.14159265358979 / 32)))});
    circle.add(corners);
    const Points points = plotted(circle, circle.legs(), plain).points;
    CHECK(points.size() == doctest::Approx(2 * 3.14159 * 20000 / 100).epsilon(0.005));
    for (std::size_t i = 1; i < points.size(); ++i)
        CHECK(distance(points[i - 1].at, points[i].at) > 97);
}

TEST_CASE("lines that begin where others end are drawn on without a break")
{
    LineStore store;
    store.add({{0, 0}, {500, 0}}, {255, 0, 0, 255});
    store.add({{500, 0}, {500, 500}}, {0, 255, 0, 255});
    store.add({{0, 0}, {500, 500}}, {0, 0, 255, 255});
    std::vector<BeamLeg> legs = store.legs();
    legs[2].is_reversed = true;
    BeamProfile profile = plain;
    profile.arrival_dwell = profile.leave_dwell = profile.lit_dwell = 5;
    profile.corner_dwell = 4;
    const Points points = plotted(store, legs, profile).points;
    CHECK(std::ranges::all_of(points, &BeamPoint::is_lit));
    // 5, 5 and 8 steps, a right angle, two of 135 degrees
    CHECK(points.size() == 5 + 5 + 8 + 2 + 3 + 3);
}

TEST_CASE("dots are lit for some points")
{
    LineStore store;
    store.add({{0, 0}});
    store.add({{9000, 0}});
    BeamProfile profile = plain;
    profile.lit_dwell = 2;
    const Points points = plotted(store, store.legs(), profile).points;
    CHECK(count_at(points, {0, 0}, true) == 8);
    CHECK(count_at(points, {9000, 0}, true) == 8);
    CHECK(points.size() == 18);
}

TEST_CASE("the light is told later than the place, all around the picture")
{
    RandomLines random{3};
    for (int round = 0; round < rounds(200); ++round) {
        LineStore store;
        random.fill(store, 5, 20);
        const std::vector<BeamLeg> legs = random.legs(store);
        BeamProfile profile = random_profile(random);
        profile.light_delay = 0;
        const Points plain_points = plotted(store, legs, profile).points;
        profile.light_delay = static_cast<std::uint8_t>(random.number(255));
        const Points late = plotted(store, legs, profile).points;
        REQUIRE(late.size() == plain_points.size());
        for (std::size_t i = 0; i < late.size(); ++i) {
            REQUIRE(late[i].at == plain_points[(i + profile.light_delay) % late.size()].at);
            REQUIRE(late[i].colour == plain_points[i].colour);
        }
    }
}

TEST_CASE("brightness is told by level, by speed or not at all")
{
    LineStore store;
    store.add({{0, 0}, {10'000, 0}}, {128, 128, 128, 255});
    store.add({{0, 9}, {10'000, 9}}, {255, 255, 255, 255});
    store.add({{0, 99}, {10'000, 99}}, {1, 1, 1, 255});
    const std::vector<BeamLeg> legs = store.legs();
    const auto points_on = [&](BeamBrightness brightness, std::int16_t y) {
        BeamProfile profile = plain;
        profile.brightness = brightness;
        const Points points = plotted(store, legs, profile).points;
        for (const BeamPoint& point : points)
            if (point.is_lit() && brightness != BeamBrightness::by_level)
                CHECK(point.colour == Colour{255, 255, 255, 255});
        return std::ranges::count_if(points, [y](const BeamPoint& p) { return p.is_lit() && p.at.y == y; });
    };
    CHECK(points_on(BeamBrightness::by_level, 0) == 101);
    CHECK(points_on(BeamBrightness::by_level, 99) == 101);
    CHECK(points_on(BeamBrightness::none, 0) == 101);
    CHECK(points_on(BeamBrightness::by_speed, 9) == 101);
    CHECK(points_on(BeamBrightness::by_speed, 0) == 52);  // steps of 100 * 255 / 128
    CHECK(points_on(BeamBrightness::by_speed, 99) == 14); // no darker than 32: 100 * 255 / 32
}

TEST_CASE("random lines are drawn within the field, evenly, and only where they are")
{
    RandomLines random{1};
    for (int round = 0; round < rounds(600); ++round) {
        CAPTURE(round);
        LineStore store;
        random.fill(store, 6, 30);
        const std::vector<BeamLeg> legs = random.legs(store);
        BeamProfile profile = random_profile(random);
        profile.light_delay = 0;
        const auto [timing, points] = plotted(store, legs, profile);
        CHECK(timing.speed_level == 0);
        REQUIRE(!points.empty());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const BeamPoint& point = points[i];
            const BeamPoint& before = points[(i == 0 ? points.size() : i) - 1];
            const double step = distance(before.at, point.at);
            if (point.is_lit()) {
                REQUIRE(step <= profile.lit_step + 2);
                REQUIRE(distance_to(store, point.at) <= 1.1);
            } else {
                REQUIRE(point.colour == Colour{.opacity = 0});
                REQUIRE((profile.travel_step == 0 || step <= profile.travel_step + 2));
            }
        }
    }
}

TEST_CASE("the corners of random lines are among their points")
{
    RandomLines random{2};
    for (int round = 0; round < rounds(300); ++round) {
        LineStore store;
        random.fill(store, 4, 20);
        const std::vector<BeamLeg> legs = random.legs(store);
        const Points points = plotted(store, legs, plain).points;
        for (std::size_t number = 0; number < store.lines.size(); ++number) {
            const std::vector<FieldPoint> line = store.points(number);
            if (!store.lines.is_closed(store.lines.line(number))) {
                CHECK(count_at(points, line.front(), true) > 0);
                CHECK(count_at(points, line.back(), true) > 0);
            }
            for (std::size_t i = 1; i + 1 < line.size(); ++i) {
                const double before = distance(line[i - 1], line[i]);
                const double after = distance(line[i], line[i + 1]);
                const double along = (line[i].x - line[i - 1].x) * double(line[i + 1].x - line[i].x) +
                                     (line[i].y - line[i - 1].y) * double(line[i + 1].y - line[i].y);
                if (std::min(before, after) >= 100 && along < 0.86 * before * after)
                    CHECK(count_at(points, line[i], true) > 0);
            }
        }
    }
}

TEST_CASE("points do not depend on how many are asked for at once, nor on an earlier haste")
{
    RandomLines random{5};
    for (int round = 0; round < rounds(200); ++round) {
        LineStore store;
        random.fill(store, 8, 30);
        const std::vector<BeamLeg> legs = random.legs(store);
        BeamProfile profile = random_profile(random);
        profile.is_laser = random.number(1) == 0;
        const std::uint32_t budget = 16 + random.number(2000);
        const auto [timing, points] = plotted(store, legs, profile, budget);
        const int guess = static_cast<int>(random.number(StepProfile::max_speed_level));
        const BeamTiming again = find_timing(store.lines, legs, profile, budget, guess);
        CHECK(again.speed_level == timing.speed_level);
        CHECK(again.legs == timing.legs);
        CHECK(all_of({store.lines, legs, profile, again}, 1 + random.number(99)) == points);
    }
}

}
