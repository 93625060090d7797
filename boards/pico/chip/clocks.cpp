#include "boards/pico/chip/clocks.hpp"

#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"

namespace kfast::pico {
namespace {

// XOSC
constexpr Register xosc_ctrl{0x4002'4000};
constexpr Register xosc_status{0x4002'4004};
constexpr Register xosc_startup{0x4002'400C};

constexpr std::uint32_t xosc_ctrl_freq_range_1_15mhz = 0xAA0;
constexpr std::uint32_t xosc_ctrl_enable = 0xFAB << 12;
constexpr std::uint32_t xosc_status_stable = 1U << 31;
// A millisecond in units of 256 periods, and six times that for crystals that are slow to swing.
constexpr std::uint32_t xosc_startup_delay = 6 * ((crystal_hz / 1000 + 128) / 256);

// CLOCKS
constexpr Register clk_ref_ctrl{0x4000'8030};
constexpr Register clk_ref_selected{0x4000'8038};
constexpr Register clk_sys_ctrl{0x4000'803C};
constexpr Register clk_sys_selected{0x4000'8044};
constexpr Register clk_peri_ctrl{0x4000'8048};
constexpr Register clk_usb_ctrl{0x4000'8054};
constexpr Register clk_adc_ctrl{0x4000'8060};
constexpr Register clk_sys_resus_ctrl{0x4000'8078};

constexpr std::uint32_t clk_ref_ctrl_src_rosc_clksrc_ph = 0;
constexpr std::uint32_t clk_ref_ctrl_src_xosc_clksrc = 2;
constexpr std::uint32_t clk_sys_ctrl_src_clk_ref = 0;
constexpr std::uint32_t clk_sys_ctrl_src_clksrc_clk_sys_aux = 1; // AUXSRC is PLL_SYS by default
constexpr std::uint32_t clk_ctrl_enable = 1 << 11; // of CLK_PERI_CTRL, CLK_USB_CTRL, CLK_ADC_CTRL

// WATCHDOG
constexpr Register watchdog_tick{0x4005'802C};
constexpr std::uint32_t watchdog_tick_enable = 1 << 9;

/// PLL_SYS or PLL_USB.
struct Pll {
    Register cs;
    Register pwr;
    Register fbdiv_int;
    Register prim;
};

constexpr Pll pll_sys{Register{0x4002'8000}, Register{0x4002'8004}, Register{0x4002'8008},
                      Register{0x4002'800C}};
constexpr Pll pll_usb{Register{0x4002'C000}, Register{0x4002'C004}, Register{0x4002'C008},
                      Register{0x4002'C00C}};

constexpr std::uint32_t cs_lock = 1U << 31;
constexpr std::uint32_t pwr_pd = 1 << 0;
constexpr std::uint32_t pwr_postdivpd = 1 << 3;
constexpr std::uint32_t pwr_vcopd = 1 << 5;
constexpr int prim_postdiv1_lsb = 16;
constexpr int prim_postdiv2_lsb = 12;

void start_crystal()
{
    xosc_ctrl.write(xosc_ctrl_freq_range_1_15mhz);
    xosc_startup.write(xosc_startup_delay);
    xosc_ctrl.set(xosc_ctrl_enable);
    while ((xosc_status.read() & xosc_status_stable) == 0) {
    }
}

void select(Register ctrl, Register selected, std::uint32_t source)
{
    ctrl.write(source);
    while (selected.read() != 1U << source) {
    }
}

void start(const Pll& pll, std::uint32_t unit, PllSetting setting)
{
    resets::restart(unit);
    pll.cs.write(1); // REFDIV: the crystal's clock, undivided
    pll.fbdiv_int.write(setting.fbdiv);
    pll.pwr.clear(pwr_pd | pwr_vcopd);
    while ((pll.cs.read() & cs_lock) == 0) {
    }
    pll.prim.write(setting.postdiv1 << prim_postdiv1_lsb | setting.postdiv2 << prim_postdiv2_lsb);
    pll.pwr.clear(pwr_postdivpd);
}

}

void start_clocks()
{
    clk_sys_resus_ctrl.write(0);
    start_crystal();
    select(clk_ref_ctrl, clk_ref_selected, clk_ref_ctrl_src_rosc_clksrc_ph);
    select(clk_sys_ctrl, clk_sys_selected, clk_sys_ctrl_src_clk_ref);
    start(pll_sys, resets::pll_sys, system_pll);
    start(pll_usb, resets::pll_usb, usb_pll);
    select(clk_ref_ctrl, clk_ref_selected, clk_ref_ctrl_src_xosc_clksrc);
    select(clk_sys_ctrl, clk_sys_selected, clk_sys_ctrl_src_clksrc_clk_sys_aux);
    clk_peri_ctrl.write(clk_ctrl_enable);
    clk_usb_ctrl.write(clk_ctrl_enable);
    clk_adc_ctrl.write(clk_ctrl_enable);
    watchdog_tick.write(crystal_hz / 1'000'000 | watchdog_tick_enable);
}

}
