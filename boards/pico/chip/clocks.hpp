#pragma once

#include "firmware/settings/rp2040_beam.hpp"

#include <cstdint>

namespace kfast::pico {

inline constexpr std::uint32_t crystal_hz = 12'000'000;

/// How a PLL makes a clock of the crystal's: times `fbdiv`, within 750 … 1600 MHz, and divided twice.
struct PllSetting {
    std::uint32_t fbdiv;
    std::uint32_t postdiv1; ///< 1 … 7, no less than the second
    std::uint32_t postdiv2; ///< 1 … 7

    constexpr std::uint32_t hz() const { return crystal_hz * fbdiv / (postdiv1 * postdiv2); }
};

inline constexpr PllSetting system_pll{125, 6, 2};
inline constexpr PllSetting usb_pll{100, 5, 5};

/// The clock of the processor, the memory, the DMA, the PIO, SPI and UART.
inline constexpr std::uint32_t system_hz = system_pll.hz();
static_assert(system_hz == rp2040::default_hz);
/// The clock of USB and the analogue-to-digital converter.
inline constexpr std::uint32_t usb_hz = usb_pll.hz();
static_assert(usb_hz == 48'000'000);

/// Starts the crystal and both PLLs, gives all units their clocks, and the timer and the watchdog their tick
/// of a microsecond.
void start_clocks();

}
