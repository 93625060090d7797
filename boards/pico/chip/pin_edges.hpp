#pragma once

#include "boards/pico/chip/register.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstdint>

/// The chip keeps in mind that a pin has fallen or risen until it is told to forget it.
namespace kfast::pico::pin_edges {

// In the registers: four bits for each pin, eight pins in each.
constexpr std::uint32_t fallen(Pin pin) { return 4u << 4 * (pin % 8); }
constexpr std::uint32_t risen(Pin pin) { return 8u << 4 * (pin % 8); }

/// What is kept in mind. A 1 that is written is forgotten, a 0 changes nothing.
constexpr Register seen(Pin pin) { return Register{0x4001'40F0 + 4u * (pin / 8u)}; }
/// What interrupts the processor.
constexpr Register interrupting(Pin pin) { return Register{0x4001'4100 + 4u * (pin / 8u)}; }

}
