#include "host/link/live_feed.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

namespace {

constexpr Milliseconds at_once{0};

}

TEST_CASE("the newest value of each input is what is taken")
{
    LiveFeed feed;
    feed.put({.places = {{0, Time{1}}, {1, Time{1}}}, .texts = {{2, "old"}}, .drawings = {{3, {{{5, 6}}}}}});
    feed.put({.places = {{1, Time{2}}}});
    feed.put({.places = {{1, Time{3}}}, .texts = {{2, "new"}, {4, "other"}}});
    feed.put({.drawings = {{3, {{{1, 2}}}}, {5, {}}}});
    CHECK(feed.take(at_once) == LiveValues{.places = {{0, Time{1}}, {1, Time{3}}},
                                           .texts = {{2, "new"}, {4, "other"}},
                                           .drawings = {{3, {{{1, 2}}}}, {5, {}}}});
    CHECK(feed.take(at_once)->empty());
}

TEST_CASE("what was put before the end is still taken")
{
    for (const LiveValues& last : {LiveValues{.places = {{0, Time{7}}}}, LiveValues{.texts = {{0, ""}}},
                                   LiveValues{.drawings = {{0, {}}}}}) {
        LiveFeed feed;
        feed.put(last);
        feed.close();
        CHECK(feed.take(at_once) == last);
        CHECK_FALSE(feed.take(Milliseconds{60'000}));
    }
}

}
