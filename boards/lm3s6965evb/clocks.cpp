#include "boards/lm3s6965evb/clocks.hpp"

#include "boards/lm3s6965evb/registers.hpp"

namespace kfast::lm3s6965evb {
namespace {

constexpr std::uint32_t main_oscillator_off = 1 << 0;
constexpr std::uint32_t oscillator_source = 3 << 4; // 0 is the main oscillator
constexpr std::uint32_t crystal = 15 << 6;
constexpr std::uint32_t crystal_8_mhz = 14 << 6;
constexpr std::uint32_t bypass_pll = 1 << 11;
constexpr std::uint32_t pll_off = 1 << 13;
constexpr std::uint32_t use_divider = 1 << 22;
constexpr std::uint32_t divider = 15 << 23;
constexpr std::uint32_t pll_locked = 1 << 6;

void start_pll()
{
    rcc.set(bypass_pll);
    rcc.clear(use_divider | main_oscillator_off);
    rcc.write((rcc.read() & ~(crystal | oscillator_source | pll_off)) | crystal_8_mhz);
}

void run_from_pll()
{
    rcc.write((rcc.read() & ~divider) | (system_divider - 1) << 23 | use_divider);
    while ((ris.read() & pll_locked) == 0) {
    }
    rcc.clear(bypass_pll);
}

}

void start_clocks()
{
    start_pll();
    run_from_pll();
    rcgc1.set(1 << 4 | 1 << 0);      // SSI0, UART0
    rcgc2.set(1 << 2 | 1 << 0);      // ports C and A
    static_cast<void>(rcgc2.read()); // a port answers a few cycles after its clock has started
}

}
