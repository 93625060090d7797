#include "boards/pico/chip/clocks.hpp"

#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"

namespace kfast::pico {
namespace {

constexpr Register xosc_control{0x4002'4000};
constexpr Register xosc_status{0x4002'4004};
constexpr Register xosc_startup{0x4002'400C};

constexpr std::uint32_t xosc_1_to_15_mhz = 0xAA0;
constexpr std::uint32_t xosc_enable = 0xFAB << 12;
constexpr std::uint32_t xosc_stable = 1U << 31;
// A millisecond in units of 256 periods, and six times that for crystals that are slow to swing.
constexpr std::uint32_t xosc_delay = 6 * ((crystal_hz / 1000 + 128) / 256);

constexpr Register clk_ref_control{0x4000'8030};
constexpr Register clk_ref_selected{0x4000'8038};
constexpr Register clk_sys_control{0x4000'803C};
constexpr Register clk_sys_selected{0x4000'8044};
constexpr Register clk_peri_control{0x4000'8048};
constexpr Register clk_usb_control{0x4000'8054};
constexpr Register clk_adc_control{0x4000'8060};
constexpr Register clk_sys_resuscitation{0x4000'8078};

constexpr std::uint32_t ref_from_ring = 0;
constexpr std::uint32_t ref_from_crystal = 2;
constexpr std::uint32_t sys_from_ref = 0;
constexpr std::uint32_t sys_from_pll = 1; // the auxiliary source, which is PLL_SYS by default
constexpr std::uint32_t clock_enable = 1 << 11;

constexpr Register watchdog_tick{0x4005'802C};
constexpr std::uint32_t tick_enable = 1 << 9;

/// A PLL's registers.
struct Pll {
    Register control;
    Register power;
    Register feedback;
    Register dividers;
};

constexpr Pll pll_sys{Register{0x4002'8000}, Register{0x4002'8004}, Register{0x4002'8008},
                      Register{0x4002'800C}};
constexpr Pll pll_usb{Register{0x4002'C000}, Register{0x4002'C004}, Register{0x4002'C008},
                      Register{0x4002'C00C}};

constexpr std::uint32_t pll_locked = 1U << 31;
constexpr std::uint32_t power_down = 1 << 0;
constexpr std::uint32_t dividers_down = 1 << 3;
constexpr std::uint32_t oscillator_down = 1 << 5;

void start_crystal()
{
    xosc_control.write(xosc_1_to_15_mhz);
    xosc_startup.write(xosc_delay);
    xosc_control.set(xosc_enable);
    while ((xosc_status.read() & xosc_stable) == 0) {
    }
}

void select(Register control, Register selected, std::uint32_t source)
{
    control.write(source);
    while (selected.read() != 1U << source) {
    }
}

void start(const Pll& pll, std::uint32_t unit, PllSetting setting)
{
    resets::restart(unit);
    pll.control.write(1); // the crystal's clock, undivided
    pll.feedback.write(setting.feedback);
    pll.power.clear(power_down | oscillator_down);
    while ((pll.control.read() & pll_locked) == 0) {
    }
    pll.dividers.write(setting.first_divider << 16 | setting.second_divider << 12);
    pll.power.clear(dividers_down);
}

}

void start_clocks()
{
    clk_sys_resuscitation.write(0);
    start_crystal();
    select(clk_ref_control, clk_ref_selected, ref_from_ring);
    select(clk_sys_control, clk_sys_selected, sys_from_ref);
    start(pll_sys, resets::pll_sys, system_pll);
    start(pll_usb, resets::pll_usb, usb_pll);
    select(clk_ref_control, clk_ref_selected, ref_from_crystal);
    select(clk_sys_control, clk_sys_selected, sys_from_pll);
    clk_peri_control.write(clock_enable);
    clk_usb_control.write(clock_enable);
    clk_adc_control.write(clock_enable);
    watchdog_tick.write(crystal_hz / 1'000'000 | tick_enable);
}

}
