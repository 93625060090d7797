#pragma once

#include "boards/pico/chip/register.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstdint>

namespace kfast::pico {

/// What a pin is connected to: FUNCSEL, the numbers of the chip's function table.
enum class PinFunction : std::uint32_t { spi = 1, uart = 2, i2c = 3, pwm = 4, sio = 5, pio0 = 6, null = 31 };

/// The electrics of a pin.
enum class Pad : std::uint32_t {
    output,         ///< 4 mA, slow edges
    fast_output,    ///< 8 mA, fast edges: the wires of a display's bus
    pulled_up,      ///< an input that is high when nothing is wired to it, or I²C
    converter_input ///< no digital input and no pull: a voltage between the levels would only waste current
};

/// GPIOn_CTRL of IO_BANK0: what the pin is connected to (FUNCSEL), and what is forced on it (OUTOVER).
constexpr Register gpio_ctrl(Pin pin) { return Register{0x4001'4004 + 8u * pin}; }
inline constexpr std::uint32_t gpio_ctrl_outover_low = 2 << 8;
inline constexpr std::uint32_t gpio_ctrl_outover_high = 3 << 8;

/// Connects the pin to the function. Does nothing for no_pin.
void connect(Pin pin, PinFunction function, Pad pad);

/// A pin that the program drives. Without a pin it does nothing.
class OutputPin {
public:
    /// Drives the pin high from the beginning.
    OutputPin(Pin pin, Pad pad);

    void high() const;
    void low() const;

private:
    std::uint32_t bit_; ///< 0: no pin
};

/// A pin that pulls its wire low or lets go of it, so that others can pull it low as well; pulled up.
class OpenDrainPin {
public:
    /// Lets go from the beginning. The pin is there.
    explicit OpenDrainPin(Pin pin);

    void pull_low() const;
    void let_go() const;

private:
    std::uint32_t bit_;
};

/// Makes the pin one that the program reads, pulled up.
void connect_input(Pin pin);
bool is_high(Pin pin);

}
