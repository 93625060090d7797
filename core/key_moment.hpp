#pragma once

#include "core/clock.hpp"
#include "core/kfb_limits.hpp"
#include "core/time.hpp"

#include <cstdint>

namespace kfast {

/// Whether a scene with `inputs` of them may have a key there.
constexpr bool is_key_moment(Clock clock, Time time, std::uint32_t inputs)
{
    return clock.is_time() ? time.ticks <= kfb::max_time : clock.input <= inputs && time <= whole_input;
}

}
