#pragma once

#include "boards/pico/chip/button.hpp"
#include "boards/pico/chip/converter.hpp"
#include "firmware/run/controls.hpp"

namespace kfast::pico {

/// Where the controls of the settings are read.
class ControlPins {
public:
    explicit ControlPins(const BoardSettings& settings)
    {
        for (const Control& control : settings.controls) {
            if (control.kind == ControlKind::button)
                button::begin(control.pin);
            else if (control.kind == ControlKind::knob)
                converter::begin(control.pin);
        }
    }

    bool pressed(Pin pin) const { return button::pressed(pin); }
    int level(Pin pin) const { return converter::read(pin); }
};

static_assert(TouchedPins<ControlPins>);

}
