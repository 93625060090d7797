#pragma once

#include "firmware/chip/microseconds.hpp"

namespace kfast {

/// What OLED controllers are given before the first command: modules without a reset line reset themselves
/// when the power comes.
inline constexpr Microseconds oled_power_rise{10'000};

}
