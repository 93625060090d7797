#pragma once

#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// A time of at least 0 as the format has it: twice the frames, or twice the ticks and one.
constexpr std::uint32_t time_code(Time time)
{
    const auto ticks = static_cast<std::uint32_t>(time.ticks);
    return ticks % Time::ticks_per_frame == 0 ? ticks / Time::ticks_per_frame * 2 : ticks * 2 + 1;
}

}
