#include "core/time.hpp"

#include "core/kfb_limits.hpp"

#include <doctest/doctest.h>
#include <initializer_list>
#include <limits>

namespace kfast::test {
namespace {

constexpr std::int64_t remainder(std::int64_t ticks, std::int64_t period)
{
    return (ticks % period + period) % period;
}

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
