#pragma once

#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// A time of its own, by which a part of a scene goes: it waits, runs at its own speed, and stops, repeats or
/// turns back at its own end.
///
///     its time                once            repeat          ping_pong
///     length                     ______         /|  /|           /\  /
///                               /              / | / |          /  \/
///          0         ________  /    _________ /  |/    _______ /
///                   the time   ^ delay        ^                ^
struct Clock {
    static constexpr std::int32_t normal_speed = 1 << 16;
    static constexpr std::int32_t max_speed = 16 * normal_speed;
    /// What its time is never beyond.
    static constexpr Time end_of_time{(1 << 30) - 1};

    Driver driver = {}; ///< what it reads: the time of the scene or an earlier clock
    Time delay = {};    ///< when it starts; before that it is at its beginning
    /// Q16, within ±max_speed. If negative, it begins at its end and runs backwards; where it repeats, it is
    /// at its end and not at 0 when it begins anew.
    std::int32_t speed = normal_speed;
    Loop loop = Loop::once; ///< what happens at its end
    Time length = {};       ///< 0: it has no end; then `loop` is once, and the speed positive

    /// Its time when its driver is at `time`, rounded down to a tick.
    Time at(Time time) const;

    friend bool operator==(const Clock&, const Clock&) = default;
};

}
