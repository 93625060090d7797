#include "host/link/live_feed.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using link::InputPlace;

namespace {

constexpr Milliseconds at_once{0};

std::vector<InputPlace> places(std::uint8_t first, std::uint8_t count, std::int32_t place)
{
    std::vector<InputPlace> all;
    for (std::uint8_t input = first; input < first + count; ++input)
        all.push_back({input, Time{place}});
    return all;
}

}

TEST_CASE("the newest value of each input is what is sent")
{
    LiveFeed feed;
    feed.put(places(0, 3, 1));
    feed.put(places(1, 1, 2));
    feed.put(places(1, 1, 3));
    const auto reports = feed.take(at_once);
    REQUIRE(reports);
    REQUIRE(reports->size() == 1);
    const link::Inputs& report = reports->front();
    CHECK(report.count == 3);
    CHECK(report.places[0] == InputPlace{0, Time{1}});
    CHECK(report.places[1] == InputPlace{1, Time{3}});
    CHECK(report.places[2] == InputPlace{2, Time{1}});
    CHECK(feed.take(at_once)->empty());
}

TEST_CASE("more values than a report holds go into several")
{
    LiveFeed feed;
    feed.put(places(0, 30, 7));
    const auto reports = feed.take(at_once);
    REQUIRE(reports->size() == 3);
    CHECK((*reports)[0].count == 12);
    CHECK((*reports)[2].count == 6);
    CHECK((*reports)[2].places[5] == InputPlace{29, Time{7}});
}

TEST_CASE("what was put before the end is still sent")
{
    LiveFeed feed;
    feed.put(places(0, 1, 7));
    feed.close();
    CHECK(feed.take(at_once)->size() == 1);
    CHECK_FALSE(feed.take(Milliseconds{60'000}));
}

TEST_CASE("of the drawings of an input only the newest is sent, and none is lost at the end")
{
    LiveFeed feed;
    const ToldDrawing drawing{{{1, 2}}};
    feed.put(3, {{{5, 6}}});
    feed.put(3, drawing);
    feed.put(1, {});
    feed.close();
    CHECK(feed.take(Milliseconds{0}).value().empty());
    CHECK(feed.take_drawings() == std::map<std::uint8_t, ToldDrawing>{{1, {}}, {3, drawing}});
    CHECK_FALSE(feed.take(Milliseconds{0}));
    CHECK(feed.take_drawings().empty());
}

}
