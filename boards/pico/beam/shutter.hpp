#pragma once

#include "boards/pico/chip/pins.hpp"

/// The wire that makes the beam dark, high for dark. It is forced high as long as there is any reason for it,
/// whatever the state machine drives. Where nothing drives it, before the start and during a reset, a
/// resistor pulls it up (docs/xy.md).
namespace kfast::pico::shutter {

/// Closed, by the processor. Works before the clocks do.
void begin(Pin blank);
/// The state machine drives the wire from now on, while nothing forces it.
void hand_over();

/// Sets whether a person has armed the beam. Until then it is closed.
void set_armed(bool is_armed);
/// Sets whether there is something to show. Until then it is closed.
void set_busy(bool is_busy);
/// Closes it for good: the program is broken.
void close_for_good();

}
