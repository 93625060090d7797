#pragma once

#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// What the moments of keys count: the time of the scene, or where one of its inputs stands.
struct Clock {
    std::uint8_t input = 0; ///< 0: the time; else the number of the input, counted from 1

    constexpr bool is_time() const { return input == 0; }
    friend constexpr bool operator==(Clock, Clock) = default;
    friend constexpr auto operator<=>(Clock, Clock) = default;
};

/// Of the input `number`, where each has one, the first the lowest.
constexpr std::uint32_t bit_of_input(std::uint32_t number) { return std::uint32_t{1} << number; }

/// Where an input stands at its greatest value; at its least it stands at 0.
inline constexpr Time whole_input{65536};

}
