#include "core/time/time.hpp"

#include "core/scene/kfb_limits.hpp"

#include <doctest/doctest.h>
#include <initializer_list>
#include <limits>

namespace kfast::test {
namespace {

constexpr std::int64_t remainder(std::int64_t ticks, std::int64_t period)
{
    return (ticks % period + period) % period;
}

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

TEST_CASE("any time wraps into scenes of any length")
{
    using Limits = std::numeric_limits<std::int32_t>;
    for (const std::int32_t length : {1, 1024, 1025, 30 * 1024, kfb::max_time, (1 << 30) - 1}) {
        for (const std::int32_t from : {Limits::min(), -length, -1024, -1, length - 2, Limits::max() - 3}) {
            for (std::int32_t i = 0; i < 4; ++i) {
                const std::int32_t ticks = from + i;
                CAPTURE(length);
                CAPTURE(ticks);
                const std::int64_t there_and_back = remainder(ticks, std::int64_t{2} * length);
                CHECK(wrap({ticks}, {length}, Loop::repeat).ticks == remainder(ticks, length));
                CHECK(wrap({ticks}, {length}, Loop::ping_pong).ticks ==
                      std::min(there_and_back, std::int64_t{2} * length - there_and_back));
                CHECK(wrap({ticks}, {length}, Loop::once).ticks == std::clamp(ticks, 0, length));
            }
        }
    }
}

}
