#include "host/art/prepare/fewer_keys.hpp"

#include "host/art/animation/ease.hpp"
#include "host/art/animation/fitted_ease.hpp"
#include "host/art/document/value_distance.hpp"
#include "host/geometry/shape.hpp"
#include "tests/host/art/random_document.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {
namespace {

using art::Animated;
using art::Channel;
using art::Drawing;
using art::Ease;
using art::EaseKind;
using art::Key;
using art::NewEases;

/// Right before each key as well: jumps lie there.
double worst(const Channel& left, const Channel& right, double from, double to)
{
    double max = 0;
    for (int i = 0; i <= 4000; ++i) {
        const double time = from + (to - from) * i / 4000;
        max = std::max(max, std::abs(left.at(time) - right.at(time)));
    }
    for (const auto& key : left.keys)
        for (const double time : {key.time, key.time - 1e-6})
            max = std::max(max, std::abs(left.at(time) - right.at(time)));
    return max;
}

}

TEST_CASE("a channel with fewer keys is within the tolerance at every time")
{
    std::size_t before = 0;
    std::size_t after = 0;
    for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(200)); ++seed) {
        RandomArt random{seed};
        const Channel art = random.channel(0, 60, 50);
        if (art.is_still())
            continue;
        const Channel given = random.crowded(art, 0.01);
        Channel fewer = given;
        NewEases eases;
        const double tolerance = random.number(0.005, 0.2);
        art::leave_out_keys(fewer, tolerance, eases);
        CHECK(worst(given, fewer, -1, 61) <= tolerance);
        before += given.keys.size();
        after += fewer.keys.size();
    }
    CHECK(after * 4 < before * 3);
}

TEST_CASE("what was divided is one way again")
{
    for (unsigned seed = 0; seed < 60; ++seed) {
        RandomArt random{seed};
        const Ease ease{EaseKind::cubic, random.number(0.2, 0.8), random.number(0, 1),
                        random.number(0.2, 0.8), random.number(0, 1)};
        const Channel given = random.crowded(Channel{{{3, -20, ease}, {30, 70, {}}}}, 0);
        Channel fewer = given;
        NewEases eases;
        art::leave_out_keys(fewer, 0.05, eases);
        CHECK(fewer.keys.size() == 2);
        CHECK(worst(given, fewer, 0, 40) <= 0.05);
    }
}

TEST_CASE("keys at every frame become a few eased ways")
{
    std::vector<Key<double>> keys;
    for (int i = 0; i <= 90; ++i)
        keys.push_back({static_cast<double>(i), 40 * std::sin(2 * std::numbers::pi * i / 45), {}});
    const Channel given{keys};
    Channel fewer = given;
    NewEases eases;
    art::leave_out_keys(fewer, 0.2, eases);
    CHECK(fewer.keys.size() < 20);
    CHECK(worst(given, fewer, 0, 90) <= 0.2);
}

TEST_CASE("what stands still loses its keys, and ways that lead nowhere their ease")
{
    NewEases eases;
    Channel still{{{0, 5, {EaseKind::cubic, 0.1, 2, 0.2, 3}}, {5, 5, {EaseKind::hold}}, {9, 5, {}}}};
    art::leave_out_keys(still, 0, eases);
    CHECK(still == Channel{{{0, 5, {}}}});
    Channel waits{{{0, 5, {}}, {5, 5, {}}, {9, 8, {}}, {12, 8, {}}, {13, 8, {}}}};
    art::leave_out_keys(waits, 0, eases);
    CHECK(waits == Channel{{{5, 5, {}}, {9, 8, {}}}});
    Channel stairs{
        {{0, 1, {EaseKind::hold}}, {1, 1, {EaseKind::hold}}, {2, 2, {EaseKind::hold}}, {3, 3, {}}}};
    art::leave_out_keys(stairs, 0, eases);
    CHECK(stairs.keys.size() == 3);
    CHECK(stairs.at(1.99) == 1);
    CHECK(stairs.at(2.99) == 2);
    Channel swings{{{0, 5, {EaseKind::cubic, 0.3, 1, 0.2, 3}}, {5, 5.01, {}}}};
    art::leave_out_keys(swings, 0.02, eases);
    CHECK(!swings.is_still());
}

TEST_CASE("drawings are compared point by point, those of other form are left alone")
{
    const auto at = [](double x) { return Drawing{{scene::ellipse({x, 5}, 4, 4)}}; };
    const Drawing square{{scene::rectangle({0, 0}, 9, 9, 0)}};
    Animated<Drawing> moving{{{0, at(0), {}}, {4, at(8.2), {}}, {5, at(10), {}}, {9, square, {}}}};
    NewEases eases;
    Animated<Drawing> same = moving;
    art::leave_out_keys(same, 0.01, eases);
    CHECK(same == moving);
    art::leave_out_keys(moving, 0.3, eases);
    REQUIRE(moving.keys.size() == 3);
    CHECK(moving.keys[1].time == 5);
}

TEST_CASE("colours go with the channel that differs most")
{
    NewEases eases;
    Animated<art::Rgb> colour{{{0, {0, 0, 0}, {}}, {5, {0.5, 0.5, 0.5}, {}}, {10, {1, 1, 1}, {}}}};
    Animated<art::Rgb> bent = colour;
    bent.keys[1].value.green = 0.51;
    art::leave_out_keys(colour, 1e-6, eases);
    CHECK(colour.keys.size() == 2);
    art::leave_out_keys(bent, 0.005, eases);
    CHECK(bent.keys.size() == 3);
}

TEST_CASE("a fitted ease goes as the one whose ways are given")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        RandomArt random{seed};
        const Ease ease{EaseKind::cubic, random.number(0.1, 0.9), random.number(0, 1),
                        random.number(0.1, 0.9), random.number(0, 1)};
        std::vector<double> ways;
        for (int i = 0; i <= 24; ++i)
            ways.push_back(share_of_way(ease, i / 24.0));
        const auto fitted = art::fitted_ease(ways);
        REQUIRE(fitted);
        for (int i = 0; i <= 100; ++i)
            CHECK(std::abs(share_of_way(*fitted, i / 100.0) - share_of_way(ease, i / 100.0)) < 0.05);
    }
}

}
