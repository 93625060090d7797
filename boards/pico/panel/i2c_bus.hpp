#pragma once

#include "firmware/panel/bus.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <span>

namespace kfast::pico {

/// A display on I2C0 or I2C1, whichever the clock pin belongs to. D/C is a control byte before every
/// transfer: 0x00 for commands, 0x40 for data, as SSD1306 and its like take it. Interrupts feed the unit. A
/// transfer that no display answers ends early, and the next one is tried all the same; the log reports the
/// first such one, and the first after the display has answered again.
class I2cBus {
public:
    /// The settings keep all rules (board_rules.hpp) and are for I²C. There is one bus. Frees the wires from
    /// a display that was interrupted. Needs start_clocks() and a clock that has begun.
    explicit I2cBus(const BoardSettings& settings);

    void command(std::span<const std::byte> bytes);
    void parameters(std::span<const std::byte> bytes);
    void start_data(std::span<const std::byte> bytes);
    bool busy() const;
};

static_assert(DisplayBus<I2cBus>);

}
