#include "tests/core/beam/plotted.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

/// How a picture keeps to its budget, and what a laser is kept from.
namespace kfast::test {

TEST_CASE("a picture keeps to its budget, whatever there is to draw, and is what was counted")
{
    RandomLines random{6};
    for (int round = 0; round < rounds(400); ++round) {
        CAPTURE(round);
        LineStore store{400'000};
        random.fill(store, 1U << random.number(10), 1U << random.number(6));
        const std::vector<BeamLeg> legs = random.legs(store);
        BeamProfile profile = random_profile(random);
        profile.lit_step = static_cast<std::uint16_t>(1 + random.number(65534));
        const std::uint32_t budget = 3 + random.number(1U << random.number(12));
        const auto [timing, points] = plotted(store, legs, profile, budget);
        CHECK(points.size() <= budget);
        CHECK(points.size() == timing.amount.points);
        const auto lit = std::ranges::count_if(points, &BeamPoint::is_lit);
        CHECK(static_cast<std::uint32_t>(lit) == timing.amount.lit_points);
        if (store.lines.size() * 3 <= budget)
            CHECK(timing.legs == store.lines.size());
        else if (timing.legs < store.lines.size())
            CHECK(timing.legs * 3 + 3 > budget);
    }
}

/// A board has memory for no more than the budget.
TEST_CASE("a laser keeps to the smallest budgets, and begins in the dark")
{
    RandomLines random{8};
    for (int round = 0; round < rounds(400); ++round) {
        CAPTURE(round);
        LineStore store{400'000};
        random.fill(store, 1U << random.number(6), 1U << random.number(6));
        BeamProfile profile = random_profile(random);
        profile.is_laser = true;
        const std::uint32_t budget = 1 + random.number(1U << random.number(10));
        const auto [timing, points] = plotted(store, random.legs(store), profile, budget);
        CHECK(points.size() <= budget);
        CHECK(points.size() == timing.amount.points);
        CHECK(!points.front().is_lit());
    }
}

TEST_CASE("the beam hurries no more than it has to")
{
    LineStore store;
    store.add({{-30'000, 0}, {30'000, 0}});
    const auto speed_level = [&](std::uint32_t budget) {
        const Plotted drawn = plotted(store, store.legs(), plain, budget);
        CHECK(drawn.points.size() <= budget);
        return drawn.timing.speed_level;
    };
    CHECK(speed_level(602) == 0);
    CHECK(speed_level(601) == 1);
    CHECK(speed_level(360) == 3);
    CHECK(speed_level(302) == 4);
    CHECK(speed_level(301) == 5);
    CHECK(speed_level(3) == 37);
    CHECK(plotted(store, store.legs(), plain, 2).timing.legs == 0);
}

TEST_CASE("lengths are what the beam goes along")
{
    LineStore store;
    store.add({{0, 0}, {300, 0}, {300, 400}});
    store.add({{600, 800}, {0, 800}});
    const BeamAmount amount = plotted(store, store.legs(), plain).timing.amount;
    CHECK(amount.lit_length == 300 + 400 + 600);
    CHECK(amount.blanked_length == doctest::Approx(500 + 800).epsilon(0.003));
}

TEST_CASE("many sharp and many short pieces keep the beam on its way")
{
    LineStore store{400'000};
    std::vector<FieldPoint> zigzag;
    zigzag.reserve(20'000);
    for (int i = 0; i < 20'000; ++i)
        zigzag.push_back(
            {static_cast<std::int16_t>(i % 2 == 0 ? -32768 : 32767), static_cast<std::int16_t>(i - 10'000)});
    store.add(zigzag);
    std::vector<FieldPoint> fine;
    fine.reserve(20'000);
    for (int i = 0; i < 20'000; ++i)
        fine.push_back({static_cast<std::int16_t>(i % 3), static_cast<std::int16_t>(i - 10'000)});
    store.add(fine);
    BeamProfile profile = plain;
    profile.lit_step = 1;
    profile.corner_dwell = 255;
    for (const std::uint32_t budget : {16U, 100U, 2500U, 100'000U}) {
        const Plotted drawn = plotted(store, store.legs(), profile, budget);
        CHECK(drawn.points.size() <= budget);
        CHECK(drawn.timing.legs == 2);
        CHECK(drawn.points.size() > budget / 3);
    }
}

TEST_CASE("lines that are longer than 32 bits hold are drawn from end to end")
{
    LineStore store{400'000};
    std::vector<FieldPoint> zigzag;
    zigzag.reserve(60'000);
    for (int i = 0; i < 60'000; ++i)
        zigzag.push_back(i % 2 == 0 ? FieldPoint{-32768, -32768} : FieldPoint{32767, 32767});
    zigzag.push_back({0, 5});
    store.add(zigzag);
    const auto [timing, points] = plotted(store, store.legs(), plain, 16);
    CHECK(timing.legs == 1);
    CHECK(timing.amount.lit_length == doctest::Approx(59'999.5 * 92'681).epsilon(0.001));
    CHECK(points.size() <= 16);
    CHECK(count_at(points, {-32768, -32768}, true) > 0);
    CHECK(count_at(points, {0, 5}, true) > 0);
}

TEST_CASE("a laser never stays lit at one place, over and over")
{
    LineStore store;
    for (int i = 0; i < 40; ++i)
        store.add({{100, 100}, {static_cast<std::int16_t>(100 + 3 * i), 120}});
    store.add({{100, 100}});
    const std::vector<BeamLeg> all = store.legs();
    for (const std::size_t legs : {std::size_t{1}, std::size_t{40}, std::size_t{41}})
        for (const std::uint32_t budget : {16U, 100U, 1500U}) {
            const std::vector<BeamLeg> some{all.end() - static_cast<std::ptrdiff_t>(legs), all.end()};
            BeamProfile profile = galvo_profile;
            profile.corner_dwell = profile.lit_dwell = 200;
            const Points points = plotted(store, some, profile, budget).points;
            const auto lit = static_cast<std::size_t>(std::ranges::count_if(points, &BeamPoint::is_lit));
            CHECK(lit >= 1);
            CHECK(lit <= 30);
            CHECK(lit * 10 <= std::max<std::size_t>(points.size(), 10));
            CHECK(points.size() >= std::min<std::uint32_t>(budget, 300) / 2);
        }
}

}
