#pragma once

#include "firmware/settings/board_settings.hpp"

/// Switches from a pin to ground. They bounce: what is said of one may change for milliseconds after a touch.
namespace kfast::pico::button {

void begin(Pin pin);
/// Whether the switch is closed, or has been since begin() or the last call.
bool pressed(Pin pin);

}
