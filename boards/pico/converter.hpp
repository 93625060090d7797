#pragma once

#include "firmware/board_settings.hpp"

namespace kfast::pico {

/// The voltage at one of the pins 26 to 29, as a knob makes it.
class Converter {
public:
    explicit Converter(Pin pin);

    /// 0 is ground, 4095 the supply: the mean of four conversions of 2 us each.
    int read() const;

private:
    int input_;
};

}
