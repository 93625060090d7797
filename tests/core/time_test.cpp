#include "core/time.hpp"

#include <doctest/doctest.h>
#include <limits>

namespace kfast::test {
namespace {

int wrapped(int ticks, int length, Loop loop) { return wrap({ticks}, {length}, loop).ticks; }

}

TEST_CASE("repeat shows 0 up to the length, and the length looks like 0")
{
    CHECK(wrapped(0, 3000, Loop::repeat) == 0);
    CHECK(wrapped(2999, 3000, Loop::repeat) == 2999);
    CHECK(wrapped(3000, 3000, Loop::repeat) == 0);
    CHECK(wrapped(-1, 3000, Loop::repeat) == 2999);
}

TEST_CASE("once holds its ends")
{
    CHECK(wrapped(-1, 3000, Loop::once) == 0);
    CHECK(wrapped(3000, 3000, Loop::once) == 3000);
    CHECK(wrapped(9999, 3000, Loop::once) == 3000);
}

TEST_CASE("ping-pong shows each end once a pass")
{
    CHECK(wrapped(3000, 3000, Loop::ping_pong) == 3000);
    CHECK(wrapped(3001, 3000, Loop::ping_pong) == 2999);
    CHECK(wrapped(6000, 3000, Loop::ping_pong) == 0);
    CHECK(wrapped(6001, 3000, Loop::ping_pong) == 1);
    CHECK(wrapped(-1, 3000, Loop::ping_pong) == 1);
}

TEST_CASE("no time is too early or too late")
{
    for (const Loop loop : {Loop::once, Loop::repeat, Loop::ping_pong})
        for (const int length : {1024, 1'024'000'000})
            for (const int ticks : {std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
                CHECK(wrapped(ticks, length, loop) >= 0);
                CHECK(wrapped(ticks, length, loop) <= length);
            }
}

}
