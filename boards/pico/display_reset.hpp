#pragma once

#include "boards/pico/pins.hpp"
#include "firmware/board_settings.hpp"
#include "firmware/microseconds.hpp"

namespace kfast::pico {

/// Resets the display by its pin, if it has one, and returns when it takes commands of any kind.
/// `pause(Microseconds)` lets time pass.
template <class Pause>
void reset_display(const BoardSettings& settings, Pause& pause)
{
    constexpr Microseconds pulse{20};      // controllers ask for 10
    constexpr Microseconds awake{120'000}; // what the slowest need before they may leave sleep
    if (settings.pin(PinRole::reset) == no_pin)
        return;
    const OutputPin reset{settings.pin(PinRole::reset), Pad::output};
    reset.low();
    pause(pulse);
    reset.high();
    pause(awake);
}

}
