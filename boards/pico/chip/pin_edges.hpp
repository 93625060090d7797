#pragma once

#include "boards/pico/chip/register.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstdint>

/// The chip latches that a pin has fallen or risen until that is cleared.
namespace kfast::pico::pin_edges {

// In the registers: four bits for each pin, eight pins in each.
constexpr std::uint32_t edge_low(Pin pin) { return 4u << 4 * (pin % 8); }
constexpr std::uint32_t edge_high(Pin pin) { return 8u << 4 * (pin % 8); }

/// What is latched (INTR0 … INTR3 of IO_BANK0). A 1 that is written clears the bit, a 0 changes nothing.
constexpr Register intr(Pin pin) { return Register{0x4001'40F0 + 4u * (pin / 8u)}; }
/// What interrupts the processor (PROC0_INTE0 … PROC0_INTE3).
constexpr Register proc0_inte(Pin pin) { return Register{0x4001'4100 + 4u * (pin / 8u)}; }

}
