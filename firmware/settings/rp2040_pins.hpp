#pragma once

#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// What the pins of an RP2040 can do, and where a Raspberry Pi Pico has them. Everything repeats along the
/// chip, so that a pin's number says what it carries. A unit is 0 or 1: SPI0 or SPI1, and so on.
namespace kfast::rp2040 {

inline constexpr Pin pin_count = 30;

/// The unit whose clock the pin can carry.
constexpr std::optional<int> spi_clock_unit(Pin pin)
{
    return pin < pin_count && pin % 4 == 2 ? std::optional{pin / 8 % 2} : std::nullopt;
}

/// The unit that can send its data (TX, a display's MOSI) on the pin.
constexpr std::optional<int> spi_data_unit(Pin pin)
{
    return pin < pin_count && pin % 4 == 3 ? std::optional{pin / 8 % 2} : std::nullopt;
}

constexpr std::optional<int> i2c_clock_unit(Pin pin)
{
    return pin < pin_count && pin % 2 == 1 ? std::optional{pin / 2 % 2} : std::nullopt;
}

constexpr std::optional<int> i2c_data_unit(Pin pin)
{
    return pin < pin_count && pin % 2 == 0 ? std::optional{pin / 2 % 2} : std::nullopt;
}

/// The unit that can send (TX) on the pin.
constexpr std::optional<int> uart_unit(Pin pin)
{
    return pin < pin_count && pin % 4 == 0 ? std::optional{(pin + 4) / 8 % 2} : std::nullopt;
}

inline constexpr Pin first_converter_pin = 26;

/// The input of the analogue-to-digital converter.
constexpr std::optional<int> converter_input(Pin pin)
{
    return pin >= first_converter_pin && pin < pin_count ? std::optional{pin - first_converter_pin}
                                                         : std::nullopt;
}

/// Every pin carries one output of the pulse-width unit.
struct PulseOutput {
    int slice;   ///< 0 … 7, each with a counter of its own
    int channel; ///< 0 (A) or 1 (B)
};

constexpr PulseOutput pulse_output(Pin pin) { return {pin / 2 % 8, pin % 2}; }

/// The number in the pinout of a Pico, 1 … 40, 0 where the board keeps the pin for itself: its supply (23,
/// 24, 29) and its LED (25). Counted along one edge and back along the other.
inline constexpr std::array<std::uint8_t, pin_count> pico_pins{
    1,  2,  4,  5,  6,  7,  9,  10, 11, 12, 14, 15, 16, 17, 19, //
    20, 21, 22, 24, 25, 26, 27, 29, 0,  0,  0,  31, 32, 34, 0,
};

/// Where wires that are no pins of the chip go, in the same numbers.
inline constexpr std::array<std::uint8_t, 8> pico_ground_pins{3, 8, 13, 18, 23, 28, 33, 38};
inline constexpr std::uint8_t pico_supply_pin = 36; ///< 3.3 V for a display

constexpr bool is_on_pico_edge(Pin pin) { return pin < pin_count && pico_pins[pin] != 0; }

/// GP0 … GP29, as the board's own print has it.
inline constexpr std::array<std::string_view, pin_count> pin_names{
    "GP0",  "GP1",  "GP2",  "GP3",  "GP4",  "GP5",  "GP6",  "GP7",  "GP8",  "GP9",
    "GP10", "GP11", "GP12", "GP13", "GP14", "GP15", "GP16", "GP17", "GP18", "GP19",
    "GP20", "GP21", "GP22", "GP23", "GP24", "GP25", "GP26", "GP27", "GP28", "GP29",
};

/// What the chip's maker calls the other end of a role's wire; empty where any pin will do. `bus` says what
/// clock and data are.
constexpr std::string_view function_name(PinRole role, BusKind bus, Pin pin)
{
    constexpr std::array<std::string_view, 2> spi_clock{"SPI0 SCK", "SPI1 SCK"};
    constexpr std::array<std::string_view, 2> spi_data{"SPI0 TX", "SPI1 TX"};
    constexpr std::array<std::string_view, 2> i2c_clock{"I2C0 SCL", "I2C1 SCL"};
    constexpr std::array<std::string_view, 2> i2c_data{"I2C0 SDA", "I2C1 SDA"};
    constexpr std::array<std::string_view, 2> uart{"UART0 TX", "UART1 TX"};
    constexpr auto name = [](const std::array<std::string_view, 2>& names, std::optional<int> unit) {
        return unit ? names[static_cast<std::size_t>(*unit)] : std::string_view{};
    };
    if (role == PinRole::log)
        return name(uart, uart_unit(pin));
    if (bus == BusKind::spi && role == PinRole::clock)
        return name(spi_clock, spi_clock_unit(pin));
    if (bus == BusKind::spi && role == PinRole::data)
        return name(spi_data, spi_data_unit(pin));
    if (bus == BusKind::i2c && role == PinRole::clock)
        return name(i2c_clock, i2c_clock_unit(pin));
    if (bus == BusKind::i2c && role == PinRole::data)
        return name(i2c_data, i2c_data_unit(pin));
    return {};
}

}
