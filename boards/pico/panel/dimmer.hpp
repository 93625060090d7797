#pragma once

#include "firmware/settings/board_settings.hpp"

#include <cstdint>

namespace kfast::pico {

/// The backlight, lit in pulses at 30.6 kHz, which neither eyes nor ears notice. Without a pin it does
/// nothing.
class Dimmer {
public:
    /// Dark until set().
    explicit Dimmer(Pin pin);

    /// 0 is dark, 255 is lit all the time; between, light grows evenly. Eyes see the lower half as most of
    /// it.
    void set(std::uint8_t brightness) const;

private:
    Pin pin_;
};

}
