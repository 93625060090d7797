#pragma once

#include "boards/pico/chip/register.hpp"

#include <cstdint>

/// The chip's units stay in reset until they are needed.
namespace kfast::pico::resets {

// RESETS, and the bits of its registers
inline constexpr std::uint32_t adc = 1 << 0;
inline constexpr std::uint32_t dma = 1 << 2;
inline constexpr std::uint32_t i2c0 = 1 << 3;
inline constexpr std::uint32_t i2c1 = 1 << 4;
inline constexpr std::uint32_t io_bank0 = 1 << 5;
inline constexpr std::uint32_t pads_bank0 = 1 << 8;
inline constexpr std::uint32_t pio0 = 1 << 10;
inline constexpr std::uint32_t pll_sys = 1 << 12;
inline constexpr std::uint32_t pll_usb = 1 << 13;
inline constexpr std::uint32_t pwm = 1 << 14;
inline constexpr std::uint32_t spi0 = 1 << 16;
inline constexpr std::uint32_t spi1 = 1 << 17;
inline constexpr std::uint32_t timer = 1 << 21;
inline constexpr std::uint32_t uart0 = 1 << 22;
inline constexpr std::uint32_t uart1 = 1 << 23;
inline constexpr std::uint32_t usbctrl = 1 << 24;

inline constexpr Register reset{0x4000'C000};
inline constexpr Register reset_done{0x4000'C008};

/// Lets the units go; those that run already go on as they are.
inline void release(std::uint32_t units)
{
    reset.clear(units);
    while ((~reset_done.read() & units) != 0) {
    }
}

/// Gives the units the state that they have after power-up, and lets them go.
inline void restart(std::uint32_t units)
{
    reset.set(units);
    release(units);
}

}
