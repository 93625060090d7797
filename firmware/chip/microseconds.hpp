#pragma once

#include <cstdint>

namespace kfast {

/// A reading of a clock that counts microseconds and wraps after 71 minutes, or a duration.
struct Microseconds {
    std::uint32_t count = 0;

    friend constexpr bool operator==(Microseconds, Microseconds) = default;
    friend constexpr Microseconds operator+(Microseconds a, Microseconds b) { return {a.count + b.count}; }
    friend constexpr Microseconds operator-(Microseconds a, Microseconds b) { return {a.count - b.count}; }
};

/// Whether `now` is at or after `moment`; valid while the two are less than 35 minutes apart, also across the
/// wrap.
constexpr bool reached(Microseconds now, Microseconds moment) { return (now - moment).count < 0x8000'0000; }

}
