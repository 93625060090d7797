#include "host/wired/steady_clock.hpp"

#include "host/program/interruption.hpp"

#include <cstdint>
#include <ctime>
#include <utility>

namespace kfast {
namespace {

constexpr std::int64_t nanoseconds_per_second = 1'000'000'000;
constexpr std::int64_t nanoseconds_per_microsecond = 1'000;

std::int64_t nanoseconds_now()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * nanoseconds_per_second + time.tv_nsec;
}

/// False if a signal came before.
bool sleep_until(std::int64_t nanoseconds)
{
    const timespec moment{.tv_sec = nanoseconds / nanoseconds_per_second,
                          .tv_nsec = nanoseconds % nanoseconds_per_second};
    return ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &moment, nullptr) == 0;
}

Microseconds in_microseconds(std::int64_t nanoseconds)
{
    return {static_cast<std::uint32_t>(nanoseconds / nanoseconds_per_microsecond)};
}

}

Microseconds SteadyClock::now()
{
    constexpr std::int64_t longest = 30 * 60 * nanoseconds_per_second;
    const std::int64_t before = std::exchange(asked_, nanoseconds_now());
    if (before != 0 && asked_ - before > longest)
        stopped_ += asked_ - before;
    return in_microseconds(asked_ - stopped_);
}

void SteadyClock::pause(Microseconds time) const
{
    const std::int64_t end = nanoseconds_now() + time.count * nanoseconds_per_microsecond;
    while (!kfast::sleep_until(end)) {
    }
}

void SteadyClock::sleep_until(Microseconds moment)
{
    const Microseconds begin = now();
    if (reached(begin, moment))
        return;
    const std::int64_t end = asked_ + (moment - begin).count * nanoseconds_per_microsecond;
    while (!was_interrupted() && !kfast::sleep_until(end)) {
    }
}

}
