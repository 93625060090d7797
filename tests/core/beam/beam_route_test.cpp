#include "core/beam/beam_route.hpp"
#include "tests/core/beam/drawn_lines.hpp"
#include "tests/core/beam/shortest_tour.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// Whether each line is followed once, open ones from an end, closed ones from a point of theirs.
bool is_whole(const BeamLines& lines, const std::vector<BeamLeg>& legs)
{
    std::vector<int> times(lines.size());
    for (const BeamLeg& leg : legs) {
        const BeamLine& line = lines.line(leg.line);
        ++times[leg.line];
        if (lines.is_closed(line) ? leg.is_reversed || leg.start + 1 >= line.points : leg.start != 0)
            return false;
    }
    return std::ranges::all_of(times, [](int count) { return count == 1; });
}

/// By how many parts in a hundred routes of random lines are longer than the shortest ones.
struct Excess {
    double mean = 0;
    double worst = 0;
    int exact = 0;
};

Excess excess_of(std::size_t max_lines, int reach, int all)
{
    std::mt19937 random{static_cast<std::uint32_t>(max_lines * 1000 + static_cast<std::size_t>(reach))};
    Excess excess;
    for (int i = 0; i < all; ++i) {
        const DrawnLines drawn{random_lines(random, 2 + random() % (max_lines - 1), reach)};
        const auto shortest = static_cast<double>(ShortestTour{drawn.lines}.travel());
        const double more = shortest == 0 ? 0 : 100 * (static_cast<double>(drawn.travel()) / shortest - 1);
        CHECK(more >= 0);
        excess.mean += more / all;
        excess.worst = std::max(excess.worst, more);
        excess.exact += more == 0 ? 1 : 0;
    }
    return excess;
}

}

TEST_CASE("without lines there is no route, and a single line is one")
{
    CHECK(DrawnLines{{}}.route().empty());
    CHECK(DrawnLines{{{{1, 2}, {3, 4}}}}.route().size() == 1);
    CHECK(DrawnLines{{{{1, 2}}}}.travel() == 0);
}

TEST_CASE("lines are followed from where they are nearest")
{
    const DrawnLines drawn{
        {{{0, 0}, {100, 0}}, {{200, 50}, {200, 0}}, {{50, 100}, {150, 100}, {150, 150}, {50, 100}}}};
    const auto legs = drawn.route();
    CHECK(is_whole(drawn.lines, legs));
    CHECK(travel_of(drawn.lines, legs) == ShortestTour{drawn.lines}.travel());
}

TEST_CASE("a route begins with what is nearest to where the beam comes from")
{
    const DrawnLines drawn{{{{0, 0}}, {{1000, 0}}, {{1000, 1000}}, {{0, 1000}}}};
    CHECK(drawn.route({900, 900}).front().line == 2);
    CHECK(drawn.route({-9, 0}).front().line == 0);
}

TEST_CASE("no route is longer than the lines as they were drawn, with any effort")
{
    std::mt19937 random{7};
    for (int i = 0; i < rounds(400); ++i) {
        const std::size_t count = 1 + random() % 200;
        std::vector<std::uint32_t> items(count);
        for (std::size_t line = 1; line < count; ++line)
            items[line] = items[line - 1] + (random() % 4 == 0 ? 1 : 0);
        const DrawnLines drawn{random_lines(random, count, 1 << random() % 15), items};
        const std::uint32_t effort = 1U << random() % 16;
        const auto legs = drawn.route({}, effort);
        REQUIRE(is_whole(drawn.lines, legs));
        CHECK(travel_of(drawn.lines, legs) <= travel_of(drawn.lines, drawn.as_drawn()));
        CHECK(drawn.route({}, effort) == legs);
    }
}

TEST_CASE("routes of few lines are nearly as short as can be")
{
    for (const int reach : {0, 300, 3000, 20000}) {
        const Excess excess = excess_of(7, reach, rounds(400));
        CAPTURE(reach);
        MESSAGE("reach " << reach << ": " << excess.mean << " % longer, at most " << excess.worst
                         << ", exact " << excess.exact);
        CHECK(excess.mean <= 0.2);
        CHECK(excess.worst <= 10);
    }
}

TEST_CASE("lines that all lie in one place take no travel")
{
    CHECK(DrawnLines{std::vector<LinePoints>(300, {{5, 5}})}.travel() == 0);
}

TEST_CASE("a line that was drawn in pieces is followed in one go")
{
    std::mt19937 random{3};
    std::vector<LinePoints> pieces;
    for (std::int16_t i = 0; i < 60; ++i)
        pieces.push_back(
            {{static_cast<std::int16_t>(i * 500), 0}, {static_cast<std::int16_t>(i * 500 + 500), 0}});
    std::ranges::shuffle(pieces, random);
    CHECK(DrawnLines{pieces}.travel() == 30000);
}

TEST_CASE("ten thousand dots have a route that is short enough")
{
    std::mt19937 random{11};
    const DrawnLines drawn{random_lines(random, 10000, 0)};
    const auto legs = drawn.route();
    CHECK(is_whole(drawn.lines, legs));
    const double side = 60000;
    const double travel = static_cast<double>(travel_of(drawn.lines, legs)) / (side * std::sqrt(10000));
    MESSAGE("sqrt(n A) times " << travel);
    CHECK(travel < 0.9); // no tour is shorter than about 0.7 of it
}

}
