#pragma once

#include "core/time/time.hpp"

namespace kfast {

/// How many frames that is, with parts of one.
constexpr double in_frames(Time time) { return static_cast<double>(time.ticks) / Time::ticks_per_frame; }

}
