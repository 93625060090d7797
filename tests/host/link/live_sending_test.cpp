#include "host/link/live_feed.hpp"
#include "host/link/session.hpp"
#include "tests/host/link/device_pipe.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using namespace link;

namespace {

constexpr Milliseconds keep_alive{300};

/// A device that plays a scene with two inputs.
struct LiveBench : LinkBench {
    LiveBench() { REQUIRE(does(Play{.home = Home::built_in})); }
};

}

TEST_CASE("live values arrive, and what was put last is sent before the end")
{
    LiveBench device;
    DevicePipe pipe{device};
    Session session{pipe, {}};
    LiveFeed feed;
    feed.put({.places = {{0, Time{7}}, {1, Time{9}}}});
    feed.close();
    send_live(session, feed, keep_alive);
    CHECK(device.device.inputs.at(0) == Time{7});
    CHECK(device.device.inputs.at(1) == Time{9});
}

TEST_CASE("a device that has no such input any more says so, even of the last values")
{
    for (const Milliseconds::rep answers_every : {1, 25}) {
        LiveBench device;
        DevicePipe pipe{device};
        pipe.answers_every = answers_every;
        Session session{pipe, {}};
        LiveFeed feed;
        feed.put({.places = {{2, Time{7}}}});
        feed.close();
        CHECK_THROWS_AS(send_live(session, feed, keep_alive), Refusal);
    }
}

}
