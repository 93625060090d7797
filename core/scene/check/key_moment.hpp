#pragma once

#include "core/scene/kfb_limits.hpp"
#include "core/time/clock.hpp"
#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// Whether a scene may have a key there, the inputs of which are numbers where `numbers` has their bit.
constexpr bool is_key_moment(Clock clock, Time time, std::uint32_t numbers)
{
    if (clock.is_time())
        return time.ticks <= kfb::max_time;
    return clock.input <= kfb::max_inputs && (numbers >> (clock.input - 1U) & 1U) != 0 && time <= whole_input;
}

}
