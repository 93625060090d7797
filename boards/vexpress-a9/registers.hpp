#pragma once

#include "firmware/chip/register.hpp"

namespace kfast::vexpress_a9 {

// The first SP804: two timers with one interrupt
inline constexpr Register timer1_load{0x1001'1000};
inline constexpr Register timer1_value{0x1001'1004};
inline constexpr Register timer1_control{0x1001'1008};
inline constexpr Register timer2_load{0x1001'1020};
inline constexpr Register timer2_control{0x1001'1028};
inline constexpr Register timer2_int_clr{0x1001'102C};

// The PL111 of the daughterboard
inline constexpr Register lcd_timing0{0x1002'0000};
inline constexpr Register lcd_timing1{0x1002'0004};
inline constexpr Register lcd_upbase{0x1002'0010};
inline constexpr Register lcd_control{0x1002'0018};

// The CPU's own interrupt controller (GIC): of the CPU, and the distributor
inline constexpr Register gicc_ctlr{0x1E00'0100};
inline constexpr Register gicc_pmr{0x1E00'0104};
inline constexpr Register gicd_ctlr{0x1E00'1000};
inline constexpr Register gicd_isenabler1{0x1E00'1104};
inline constexpr Register gicd_itargetsr8{0x1E00'1820};

}
