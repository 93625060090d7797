#pragma once

#include "boards/pico/pins.hpp"

namespace kfast::pico {

/// A switch from the pin to ground. It bounces: what it says may change for some milliseconds after a touch.
class Button {
public:
    explicit Button(Pin pin) : pin_{pin} {}

    bool is_pressed() const { return !pin_.is_high(); }

private:
    InputPin pin_;
};

}
