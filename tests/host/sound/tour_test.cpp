#include "host/sound/tour.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <thread>

using namespace kfast;

namespace {

const Tour square{{0, 0}, {300, 0}, {300, 300}, {0, 300}};

double longest(const Tour& tour, FieldPoint next)
{
    double longest = 0;
    for (std::size_t at = 0; at < tour.size(); ++at)
        longest = std::max(longest, distance(tour[at], at + 1 < tour.size() ? tour[at + 1] : next));
    return longest;
}

Tour taken(TourPlayer& player, std::size_t count)
{
    Tour points(count);
    player.take(points);
    return points;
}

Tour operator+(Tour one, const Tour& other)
{
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

}

TEST_CASE("travel has the points between two places, at steps that are not too long")
{
    CHECK(travel({0, 0}, {300, 0}, 100) == Tour{{100, 0}, {200, 0}});
    CHECK(travel({0, 0}, {301, 0}, 100).size() == 3);
    CHECK(travel({0, 0}, {100, 0}, 100).empty());
    CHECK(travel({0, 0}, {0, 0}, 100).empty());
    CHECK(travel({0, 0}, {30000, 0}, 0).empty());
    CHECK(travel({-32768, -32768}, {32767, 32767}, 10000).size() == 9);
}

TEST_CASE("a tour is stretched to any number of points, without a longer step")
{
    CHECK(stretched(square, square.front(), 4) == square);
    const Tour twice = stretched(square, square.front(), 8);
    CHECK(twice == Tour{{0, 0}, {150, 0}, {300, 0}, {300, 150}, {300, 300}, {150, 300}, {0, 300}, {0, 150}});
    for (std::size_t count = 4; count < 40; ++count) {
        const Tour tour = stretched(square, square.front(), count);
        CHECK(tour.size() == count);
        CHECK(tour.front() == square.front());
        CHECK(longest(tour, square.front()) <= 300);
    }
    CHECK(stretched(Tour{{7, 7}}, {9, 9}, 2) == Tour{{7, 7}, {8, 8}});
}

TEST_CASE("tours are played whole, again and again, with a way between them")
{
    TourPlayer player{100};
    CHECK(taken(player, 2) == Tour{{0, 0}, {0, 0}});
    player.show(square);
    CHECK(taken(player, 6) == square + Tour{{0, 200}, {0, 100}}); // and back to its beginning
    const Tour begun = taken(player, 2);
    CHECK(begun == Tour{{0, 0}, {300, 0}});
    const Tour other{{500, 300}, {600, 300}};
    player.show(Tour{{1, 1}}); // is never seen
    player.show(other);
    const Tour way{{100, 300}, {200, 300}, {300, 300}, {400, 300}};
    CHECK(taken(player, 9) == Tour{{300, 300}, {0, 300}} + way + other + Tour{{500, 300}});
}

TEST_CASE("without a travel step the beam jumps between tours")
{
    TourPlayer player{0};
    player.show(square);
    CHECK(taken(player, 6) == Tour{{0, 0}} + square + Tour{{0, 0}});
}

TEST_CASE("tours are shown while others are taken")
{
    constexpr int rounds = 20'000;
    TourPlayer player{50};
    std::thread show{[&player] {
        for (int round = 0; round < rounds; ++round)
            player.show(
                Tour(1 + static_cast<std::size_t>(round % 7), {static_cast<std::int16_t>(round % 1000), 0}));
    }};
    double longest_seen = 0;
    FieldPoint before{};
    for (int round = 0; round < rounds / 10; ++round)
        for (const FieldPoint point : taken(player, 16)) {
            longest_seen = std::max(longest_seen, distance(before, point));
            before = point;
        }
    show.join();
    CHECK(longest_seen <= 51);
}
