#pragma once

#include "firmware/chip/register.hpp"

namespace kfast::vexpress_a9 {

// The first SP804: two timers with one interrupt
inline constexpr Register timer_load{0x1001'1000};
inline constexpr Register timer_value{0x1001'1004};
inline constexpr Register timer_control{0x1001'1008};
inline constexpr Register alarm_load{0x1001'1020};
inline constexpr Register alarm_control{0x1001'1028};
inline constexpr Register alarm_clear{0x1001'102C};

// The PL111 of the daughterboard
inline constexpr Register lcd_timing_0{0x1002'0000};
inline constexpr Register lcd_timing_1{0x1002'0004};
inline constexpr Register lcd_picture{0x1002'0010};
inline constexpr Register lcd_control{0x1002'0018};

// The CPU's own: its interrupt controller
inline constexpr Register gic_cpu_control{0x1E00'0100};
inline constexpr Register gic_cpu_priority_mask{0x1E00'0104};
inline constexpr Register gic_control{0x1E00'1000};
inline constexpr Register gic_enable_32_to_63{0x1E00'1104};
inline constexpr Register gic_cpus_of_32_to_35{0x1E00'1820};

}
