#include "core/time/clock.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

constexpr std::int32_t frame = Time::ticks_per_frame;

/// What a clock of 20 frames shows at a time, in frames.
double shown(Clock clock, double frames)
{
    clock.length = Time::frame(20);
    return static_cast<double>(clock.at({static_cast<std::int32_t>(frames * frame)}).ticks) / frame;
}

/// Step by step from the definition, in double, which is exact here.
double reference(const Clock& clock, std::int32_t time)
{
    const double waited = std::max(0.0, static_cast<double>(time) - clock.delay.ticks);
    const double run = std::floor(waited * clock.speed / Clock::normal_speed);
    const double length = clock.length.ticks;
    const double place = clock.speed < 0 ? length + run : run;
    const auto modulo = [](double value, double period) {
        return value - period * std::floor(value / period);
    };
    if (clock.loop == Loop::once)
        return std::clamp(place, 0.0, length);
    if (clock.loop == Loop::repeat)
        return clock.speed < 0 && modulo(place, length) == 0 ? length : modulo(place, length);
    const double there_and_back = modulo(place, 2 * length);
    return std::min(there_and_back, 2 * length - there_and_back);
}

}

TEST_CASE("a clock waits at its beginning, then runs")
{
    const Clock late{.delay = Time::frame(5)};
    CHECK(shown(late, 0) == 0);
    CHECK(shown(late, 5) == 0);
    CHECK(shown(late, 5.5) == 0.5);
    CHECK(shown(late, 25) == 20);
    CHECK(shown(late, 99) == 20);
    CHECK(shown({.delay = Time::frame(-5)}, 0) == 5);
}

TEST_CASE("a clock repeats and turns back at its end")
{
    CHECK(shown({.loop = Loop::repeat}, 20) == 0);
    CHECK(shown({.loop = Loop::repeat}, 47) == 7);
    CHECK(shown({.delay = Time::frame(-30), .loop = Loop::repeat}, 1) == 11);
    CHECK(shown({.loop = Loop::ping_pong}, 20) == 20);
    CHECK(shown({.loop = Loop::ping_pong}, 27) == 13);
    CHECK(shown({.loop = Loop::ping_pong}, 41) == 1);
}

TEST_CASE("a clock runs at its speed, backwards from its end")
{
    constexpr std::int32_t half = Clock::normal_speed / 2;
    CHECK(shown({.speed = half}, 10) == 5);
    CHECK(shown({.speed = 3 * Clock::normal_speed, .loop = Loop::repeat}, 9) == 7);
    CHECK(shown({.speed = -half}, 0) == 20);
    CHECK(shown({.speed = -half}, 10) == 15);
    CHECK(shown({.speed = -half}, 100) == 0);
    CHECK(shown({.speed = -half, .loop = Loop::repeat}, 0) == 20);
    CHECK(shown({.speed = -half, .loop = Loop::repeat}, 40) == 20);
    CHECK(shown({.speed = -half, .loop = Loop::repeat}, 44) == 18);
    CHECK(shown({.speed = -half, .loop = Loop::ping_pong}, 44) == 2);
}

TEST_CASE("a clock without an end goes on, within what a time holds")
{
    CHECK(Clock{.speed = 2 * Clock::normal_speed}.at({3000}) == Time{6000});
    CHECK(Clock{.delay = {-kfb::max_time}, .speed = Clock::max_speed}.at({kfb::max_time}) ==
          Clock::end_of_time);
}

TEST_CASE("clocks of all kinds show what their definition says")
{
    std::mt19937 random{7};
    const auto any = [&](std::int32_t min, std::int32_t max) {
        return std::uniform_int_distribution{min, max}(random);
    };
    for (int i = 0; i < 20'000; ++i) {
        const bool is_short = i % 2 == 0;
        const Clock clock{.delay = {any(-kfb::max_time, kfb::max_time)},
                          .speed = any(-Clock::max_speed, Clock::max_speed),
                          .loop = static_cast<Loop>(any(0, 2)),
                          .length = {any(1, is_short ? 5000 : kfb::max_time)}};
        const std::int32_t time = any(0, kfb::max_time);
        CAPTURE(i);
        REQUIRE(clock.at({time}).ticks == reference(clock, time));
    }
}

}
