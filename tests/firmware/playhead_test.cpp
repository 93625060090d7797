#include "firmware/playhead.hpp"

#include "core/kfb_limits.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::test {
namespace {

std::vector<int> ticks(Time length, Loop loop, int frames)
{
    Playhead playhead{length, loop};
    std::vector<int> result;
    for (int i = 0; i < frames; ++i) {
        result.push_back(playhead.time().ticks);
        playhead.advance(1);
    }
    return result;
}

}

TEST_CASE("repeat shows the end as the beginning")
{
    CHECK(ticks(Time::frame(3), Loop::repeat, 7) == std::vector{0, 1024, 2048, 0, 1024, 2048, 0});
    CHECK(ticks(Time::frame(1), Loop::repeat, 3) == std::vector{0, 0, 0});
}

TEST_CASE("repeat of a length between two frames keeps the pace")
{
    CHECK(ticks({2500}, Loop::repeat, 6) == std::vector{0, 1024, 2048, 572, 1596, 120});
}

TEST_CASE("once stops at exactly its length and holds")
{
    CHECK(ticks(Time::frame(2), Loop::once, 5) == std::vector{0, 1024, 2048, 2048, 2048});
    CHECK(ticks({1500}, Loop::once, 4) == std::vector{0, 1024, 1500, 1500});
}

TEST_CASE("ping-pong shows each end once")
{
    CHECK(ticks(Time::frame(2), Loop::ping_pong, 8) == std::vector{0, 1024, 2048, 1024, 0, 1024, 2048, 1024});
    CHECK(ticks(Time::frame(1), Loop::ping_pong, 4) == std::vector{0, 1024, 0, 1024});
}

TEST_CASE("frames that are left out still pass")
{
    Playhead playhead{Time::frame(5), Loop::repeat};
    playhead.advance(1003);
    CHECK(playhead.time() == Time::frame(3));
}

TEST_CASE("the longest scenes do not overflow")
{
    constexpr Time longest{kfb::max_time - 1};
    for (const Loop loop : {Loop::once, Loop::repeat, Loop::ping_pong}) {
        Playhead playhead{longest, loop};
        playhead.advance(999'999);
        CHECK(playhead.time() == Time::frame(999'999));
        playhead.advance(2); // the end lies 1023 ticks further
        CHECK(playhead.time().ticks == (loop == Loop::once     ? longest.ticks
                                        : loop == Loop::repeat ? 1025
                                                               : longest.ticks - 1025));
    }
    Playhead there_and_back{longest, Loop::ping_pong};
    there_and_back.advance(2 * 999'999 + 1);
    CHECK(there_and_back.time().ticks == 1022);
    there_and_back.advance(1);
    CHECK(there_and_back.time().ticks == 2);
}

}
