#pragma once

#include "firmware/serial/pl011.hpp"

namespace kfast::lm3s6965evb {

/// UART0: 115200 baud, 8 bits, no parity, on PA0 and PA1.
inline constexpr Pl011 uart{0x4000'C000};

void start_uart();

}
