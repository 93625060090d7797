#pragma once

#include "firmware/chip/register.hpp"

namespace kfast::lm3s6965evb {

// System control
inline constexpr Register ris{0x400F'E050};
inline constexpr Register rcc{0x400F'E060};
inline constexpr Register rcgc1{0x400F'E104};
inline constexpr Register rcgc2{0x400F'E108};

// Port A: UART0 and SSI0
inline constexpr Register gpio_a_afsel{0x4000'4420};
inline constexpr Register gpio_a_den{0x4000'451C};

// Port C: PC7 is D/C of the display
inline constexpr Register gpio_c_data_pin7{0x4000'6000 + (0x80 << 2)}; // a write changes only this pin
inline constexpr Register gpio_c_dir{0x4000'6400};
inline constexpr Register gpio_c_den{0x4000'651C};

// SSI0 (PL022)
inline constexpr Register ssicr0{0x4000'8000};
inline constexpr Register ssicr1{0x4000'8004};
inline constexpr Register ssidr{0x4000'8008};
inline constexpr Register ssisr{0x4000'800C};
inline constexpr Register ssicpsr{0x4000'8010};
inline constexpr Register ssiim{0x4000'8014};

}
