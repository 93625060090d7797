#include "boards/lm3s6965evb/clocks.hpp"

#include "boards/lm3s6965evb/registers.hpp"

namespace kfast::lm3s6965evb {
namespace {

constexpr std::uint32_t rcc_moscdis = 1 << 0;
constexpr std::uint32_t rcc_oscsrc = 3 << 4; // 0 is the main oscillator
constexpr std::uint32_t rcc_xtal = 15 << 6;
constexpr std::uint32_t rcc_xtal_8_mhz = 14 << 6;
constexpr std::uint32_t rcc_bypass = 1 << 11;
constexpr std::uint32_t rcc_pwrdn = 1 << 13;
constexpr std::uint32_t rcc_usesysdiv = 1 << 22;
constexpr int rcc_sysdiv_lsb = 23;
constexpr std::uint32_t rcc_sysdiv = 15 << rcc_sysdiv_lsb;
constexpr std::uint32_t ris_plllris = 1 << 6;
constexpr std::uint32_t rcgc1_uart0 = 1 << 0;
constexpr std::uint32_t rcgc1_ssi0 = 1 << 4;
constexpr std::uint32_t rcgc2_gpioa = 1 << 0;
constexpr std::uint32_t rcgc2_gpioc = 1 << 2;

void start_pll()
{
    rcc.set(rcc_bypass);
    rcc.clear(rcc_usesysdiv | rcc_moscdis);
    rcc.write((rcc.read() & ~(rcc_xtal | rcc_oscsrc | rcc_pwrdn)) | rcc_xtal_8_mhz);
}

void run_from_pll()
{
    rcc.write((rcc.read() & ~rcc_sysdiv) | (system_divider - 1) << rcc_sysdiv_lsb | rcc_usesysdiv);
    while ((ris.read() & ris_plllris) == 0) {
    }
    rcc.clear(rcc_bypass);
}

}

void start_clocks()
{
    start_pll();
    run_from_pll();
    rcgc1.set(rcgc1_ssi0 | rcgc1_uart0);
    rcgc2.set(rcgc2_gpioc | rcgc2_gpioa);
    static_cast<void>(rcgc2.read()); // a port answers a few cycles after its clock has started
}

}
