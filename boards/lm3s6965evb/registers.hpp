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
inline constexpr Register gpio_c_pin7{0x4000'6000 + (0x80 << 2)}; // a write changes this pin alone
inline constexpr Register gpio_c_dir{0x4000'6400};
inline constexpr Register gpio_c_den{0x4000'651C};

// SSI0 (PL022)
inline constexpr Register ssi_cr0{0x4000'8000};
inline constexpr Register ssi_cr1{0x4000'8004};
inline constexpr Register ssi_dr{0x4000'8008};
inline constexpr Register ssi_sr{0x4000'800C};
inline constexpr Register ssi_cpsr{0x4000'8010};
inline constexpr Register ssi_im{0x4000'8014};

// The CPU's own
inline constexpr Register systick_control{0xE000'E010};
inline constexpr Register systick_reload{0xE000'E014};
inline constexpr Register systick_value{0xE000'E018};
inline constexpr Register nvic_enable{0xE000'E100};
inline constexpr Register cpacr{0xE000'ED88};

}
