#include "firmware/run/frame_clock.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

namespace kfast::test {

TEST_CASE("frame 0 is due at the start") { CHECK(FrameClock{30'000, {5}}.due() == Microseconds{5}); }

TEST_CASE("frame n is due at start + n / rate, rounded down, however long it runs")
{
    for (const std::uint32_t rate :
         {1u, 23'976u, 30'000u, 59'940u, 60'000u, 999'999u, 2'000'000'000u, 4'294'967'295u}) {
        CAPTURE(rate);
        const Microseconds start{123};
        FrameClock clock{rate, start};
        for (std::uint64_t frame = 1; frame <= 100'000; ++frame) {
            const bool moved_once = clock.advance(clock.due() - Microseconds{1}) == 1;
            const std::uint64_t exact = 1'000'000'000ull * frame / rate;
            const bool right = clock.due() == start + Microseconds{static_cast<std::uint32_t>(exact)};
            REQUIRE((moved_once && right));
        }
    }
}

TEST_CASE("the counter of the microseconds wraps unnoticed")
{
    FrameClock clock{50'000, {0xFFFF'FFFF - 29'999}}; // wraps after one frame and a half
    CHECK(clock.advance({0xFFFF'FFFF - 25'000}) == 1);
    CHECK(clock.due() == Microseconds{0xFFFF'FFFF - 9'999});
    CHECK(clock.advance({0xFFFF'FFFF - 5'000}) == 1);
    CHECK(clock.due() == Microseconds{10'000});
    CHECK(clock.advance({15'000}) == 1);
    CHECK(clock.due() == Microseconds{30'000});
}

TEST_CASE("a frame that is late but not yet over is shown")
{
    FrameClock clock{50'000, {0}};
    CHECK(clock.advance({39'999}) == 1);
    CHECK(clock.due() == Microseconds{20'000});
}

TEST_CASE("frames whose time has passed are left out and counted")
{
    FrameClock clock{50'000, {0}};
    CHECK(clock.advance({40'000}) == 2);
    CHECK(clock.due() == Microseconds{40'000});
    CHECK(clock.advance({119'999}) == 3);
    CHECK(clock.due() == Microseconds{100'000});
    CHECK(clock.advance({100'001}) == 1);
    CHECK(clock.due() == Microseconds{120'000});
}

TEST_CASE("reached() is right on both sides of the wrap")
{
    CHECK(reached({5}, {5}));
    CHECK(reached({6}, {5}));
    CHECK_FALSE(reached({5}, {6}));
    CHECK(reached({3}, {0xFFFF'FFFE}));
    CHECK_FALSE(reached({0xFFFF'FFFE}, {3}));
}

}
