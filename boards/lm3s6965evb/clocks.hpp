#pragma once

#include <cstdint>

namespace kfast::lm3s6965evb {

/// The 8 MHz crystal drives a PLL of 400 MHz, halved before the divider: 200 MHz / 4.
inline constexpr std::uint32_t pll_hz = 200'000'000;
inline constexpr std::uint32_t system_divider = 4;
inline constexpr std::uint32_t system_hz = pll_hz / system_divider;
static_assert(system_hz == 50'000'000, "the most that the chip is made for");

/// Sets the system clock and lets it reach SSI0, UART0 and ports A and C.
void start_clocks();

}
