#pragma once

#include <compare>
#include <cstdint>

namespace kfast {

/// A moment or a length on the timeline of a scene, in 1/1024 frame.
struct Time {
    std::int32_t ticks = 0;

    static constexpr std::int32_t ticks_per_frame = 1024;
    static constexpr Time frame(std::int32_t number) { return {number * ticks_per_frame}; }

    friend constexpr auto operator<=>(Time, Time) = default;
    friend constexpr Time operator+(Time a, Time b) { return {a.ticks + b.ticks}; }
    friend constexpr Time operator-(Time a, Time b) { return {a.ticks - b.ticks}; }
};

/// What happens at the end of a scene.
enum class Loop : std::uint8_t { once, repeat, ping_pong };

}
