#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>

namespace kfast {

/// A moment or a length on the timeline of a scene, in 1/1024 frame. Sums and differences do not check their
/// range.
struct Time {
    std::int32_t ticks = 0;

    static constexpr std::int32_t ticks_per_frame = 1024;
    /// `number` is within -2097152 … 2097151.
    static constexpr Time frame(std::int32_t number) { return {number * ticks_per_frame}; }

    friend constexpr auto operator<=>(Time, Time) = default;
    friend constexpr Time operator+(Time a, Time b) { return {a.ticks + b.ticks}; }
    friend constexpr Time operator-(Time a, Time b) { return {a.ticks - b.ticks}; }
};

/// What happens at the end of a scene; the values are those of the scene format.
enum class Loop : std::uint8_t {
    once,      ///< stops exactly at the end and holds it
    repeat,    ///< the end looks like the beginning
    ping_pong, ///< runs back and forth, each end shown once a pass
};

/// The moment of a scene of `length` (at least 1 tick, less than 2^30) that is shown at `time`.
constexpr Time wrap(Time time, Time length, Loop loop)
{
    if (loop == Loop::once)
        return std::clamp(time, Time{0}, length);
    const std::int32_t period = loop == Loop::ping_pong ? 2 * length.ticks : length.ticks;
    const std::int32_t rest = time.ticks % period;
    const std::int32_t within = rest < 0 ? rest + period : rest;
    return {within > length.ticks ? period - within : within};
}

}
