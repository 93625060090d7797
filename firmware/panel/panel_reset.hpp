#pragma once

#include "firmware/chip/microseconds.hpp"

/// What display controllers ask of their reset line.
namespace kfast {

/// Low for so long; they ask for 10.
inline constexpr Microseconds panel_reset_pulse{20};

/// And high for so long before anything is sent: what the slowest need before they may leave sleep.
inline constexpr Microseconds rest_after_panel_reset{120'000};

}
