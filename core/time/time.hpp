#pragma once

#include "core/bytes/expects.hpp"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A time or a duration on the timeline of a scene, in 1/1024 frame. Sums and differences do not check their
/// range.
struct Time {
    std::int32_t ticks = 0;

    static constexpr std::int32_t ticks_per_frame = 1024;
    /// `number` is within -2097152 … 2097151.
    static constexpr Time frame(std::int32_t number)
    {
        expects(number >= -2097152 && number <= 2097151);
        return {number * ticks_per_frame};
    }

    friend constexpr auto operator<=>(Time, Time) = default;
    friend constexpr Time operator+(Time a, Time b) { return {a.ticks + b.ticks}; }
    friend constexpr Time operator-(Time a, Time b) { return {a.ticks - b.ticks}; }
};

/// What happens at the end of a scene; the values are those of the scene format.
enum class Loop : std::uint8_t {
    once,      ///< stops exactly at the end and stays there
    repeat,    ///< the end looks like the beginning
    ping_pong, ///< runs back and forth, each end shown once a pass
};

/// The time of a scene of `length` (at least 1 tick, less than 2^30) that is shown at `time`.
constexpr Time wrap(Time time, Time length, Loop loop)
{
    expects(length.ticks >= 1 && length.ticks < 1 << 30);
    if (loop == Loop::once)
        return std::clamp(time, Time{0}, length);
    const std::int32_t period = loop == Loop::ping_pong ? 2 * length.ticks : length.ticks;
    const std::int32_t rest = time.ticks % period;
    const std::int32_t within = rest < 0 ? rest + period : rest;
    return {within > length.ticks ? period - within : within};
}

/// What the times of keys go by: the time of the scene, the place of one of its inputs, or one of its clocks
/// (core/time/clock.hpp).
struct Driver {
    static constexpr std::uint8_t first_clock = 33;

    std::uint8_t number = 0; ///< 0: the time; up to 32: the input, counted from 1; from 33 on: the clock

    /// `index` is that of a clock of the scene.
    static constexpr Driver of_clock(std::size_t index)
    {
        return {static_cast<std::uint8_t>(first_clock + index)};
    }
    constexpr bool is_time() const { return number == 0; }
    constexpr bool is_clock() const { return number >= first_clock; }
    constexpr bool is_input() const { return !is_time() && !is_clock(); }
    /// The index of the input or the clock; only of one.
    constexpr std::size_t index() const { return number - (is_clock() ? std::size_t{first_clock} : 1U); }
    friend constexpr bool operator==(Driver, Driver) = default;
    friend constexpr auto operator<=>(Driver, Driver) = default;
};

/// The bit of the input `number`, 0 … 31; the first input has the lowest bit.
constexpr std::uint32_t bit_of_input(std::uint32_t number)
{
    expects(number < 32);
    return std::uint32_t{1} << number;
}

/// The place of an input at its maximum; at its minimum it is at 0.
inline constexpr Time whole_input{65536};

/// The places of all drivers of a scene at one time.
class SceneTime {
public:
    /// `inputs`, from 0 to whole_input each, and `clocks` must outlive the SceneTime. One that is not set is
    /// at 0.
    constexpr SceneTime(Time time = {}, std::span<const Time> inputs = {}, std::span<const Time> clocks = {})
        : time_{time}, inputs_{inputs}, clocks_{clocks}
    {
    }

    constexpr Time time() const { return time_; }
    constexpr std::span<const Time> inputs() const { return inputs_; }
    constexpr std::span<const Time> clocks() const { return clocks_; }
    constexpr Time at(Driver driver) const
    {
        if (driver.is_time())
            return time_;
        const std::span<const Time> places = driver.is_clock() ? clocks_ : inputs_;
        return driver.index() < places.size() ? places[driver.index()] : Time{};
    }

private:
    Time time_;
    std::span<const Time> inputs_;
    std::span<const Time> clocks_;
};

/// On which timelines and inputs something depends at a time: a bit for each. There may be more of them than
/// bits, so that several have the same bit: then more is taken to move than does.
struct Dependence {
    std::uint32_t keys = 0;   ///< all of them
    std::uint32_t tweens = 0; ///< those between two keys that differ: it moves as these progress

    static constexpr std::uint32_t bit(std::uint32_t number) { return std::uint32_t{1} << (number % 32); }

    /// `moved` has in `keys` what is at other keys, or was set, and in `tweens` what progressed between keys.
    constexpr bool is_touched_by(const Dependence& moved) const
    {
        return ((keys & moved.keys) | (tweens & moved.tweens)) != 0;
    }
    friend constexpr Dependence operator|(const Dependence& a, const Dependence& b)
    {
        return {a.keys | b.keys, a.tweens | b.tweens};
    }
    friend constexpr bool operator==(const Dependence&, const Dependence&) = default;
};

}
