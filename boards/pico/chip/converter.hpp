#pragma once

#include "firmware/settings/board_settings.hpp"

/// Measures voltages at the pins 26 to 29, as knobs make them. Needs start_clocks().
namespace kfast::pico::converter {

void begin(Pin pin);
/// 0 is ground, 4095 the supply: the mean of four conversions of 2 us each.
int read(Pin pin);

}
