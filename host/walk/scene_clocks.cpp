#include "host/walk/scene_clocks.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int64_t one = Clock::normal_speed;

/// How long a clock that repeats or turns back takes until it shows the same again, in ticks of what it
/// reads.
std::int64_t period_of(const Clock& clock)
{
    const std::int64_t passes = clock.loop == Loop::ping_pong ? 2 : 1;
    return passes * clock.length.ticks * one / std::abs(clock.speed);
}

/// The time of what the clock reads at which it comes to `shown` in its first pass.
std::optional<std::int64_t> first_pass_at(const Clock& clock, Time shown)
{
    const bool has_end = clock.length != Time{};
    if (shown.ticks < 0 || (has_end && shown > clock.length))
        return std::nullopt;
    const std::int64_t run = clock.speed < 0 ? clock.length.ticks - shown.ticks : shown.ticks;
    if (run == 0)
        return clock.delay.ticks;
    if (clock.speed == 0)
        return std::nullopt;
    const std::int64_t speed = std::abs(clock.speed);
    return clock.delay.ticks + (run * one + speed - 1) / speed;
}

}

SceneClocks::SceneClocks(const SceneView& scene)
{
    for (ClockCursor clocks = scene.clocks(); !clocks.at_end();)
        clocks_.push_back(clocks.next());
}

std::vector<Time> SceneClocks::at(Time time) const
{
    std::vector<Time> shown;
    shown.reserve(clocks_.size());
    for (const Clock& clock : clocks_)
        shown.push_back(clock.at(SceneTime{time, {}, shown}.at(clock.driver)));
    return shown;
}

std::optional<Time> SceneClocks::first_at(std::size_t clock, Time shown) const
{
    const Clock& read = clocks_[clock];
    std::optional<std::int64_t> at = first_pass_at(read, shown);
    if (!at)
        return std::nullopt;
    if (*at < 0 && read.loop != Loop::once && read.speed != 0) {
        const std::int64_t period = std::max<std::int64_t>(period_of(read), 1);
        *at += (period - 1 - *at) / period * period;
    }
    if (*at < 0 || *at > Clock::end_of_time.ticks)
        return std::nullopt;
    const Time time{static_cast<std::int32_t>(*at)};
    return read.driver.is_clock() ? first_at(read.driver.index(), time) : time;
}

std::size_t SceneClocks::root_of(std::size_t clock) const
{
    while (clocks_[clock].driver.is_clock())
        clock = clocks_[clock].driver.index();
    return clock;
}

}
