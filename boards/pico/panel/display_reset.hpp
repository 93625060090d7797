#pragma once

#include "boards/pico/chip/pins.hpp"
#include "firmware/panel/panel_reset.hpp"
#include "firmware/settings/board_settings.hpp"

namespace kfast::pico {

/// Resets the display by its pin, if it has one, and returns when it takes commands of any kind.
/// `pause(Microseconds)` lets time pass.
template <class Pause>
void reset_display(const BoardSettings& settings, Pause& pause)
{
    if (settings.pin(PinRole::reset) == no_pin)
        return;
    const OutputPin reset{settings.pin(PinRole::reset), Pad::output};
    reset.low();
    pause(panel_reset_pulse);
    reset.high();
    pause(rest_after_panel_reset);
}

}
