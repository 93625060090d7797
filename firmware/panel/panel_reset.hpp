#pragma once

#include "firmware/chip/microseconds.hpp"

/// What display controllers require of their reset line.
namespace kfast {

/// How long it is low; they require 10.
inline constexpr Microseconds panel_reset_pulse{20};

/// How long it is high before anything is sent: what the slowest need before they may leave sleep.
inline constexpr Microseconds rest_after_panel_reset{120'000};

}
