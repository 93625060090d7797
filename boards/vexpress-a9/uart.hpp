#pragma once

#include "firmware/serial/pl011.hpp"

namespace kfast::vexpress_a9 {

/// UART0: 115200 baud from 24 MHz, 8 bits, no parity.
inline constexpr Pl011 uart{0x1000'9000};
inline constexpr std::uint32_t uart_divisor = Pl011::divisor(24'000'000, 115'200);
static_assert(uart_divisor == 13 * 64 + 1);

}
