#include "boards/lm3s6965evb/clock.hpp"

#include "boards/lm3s6965evb/clocks.hpp"
#include "firmware/chip/cortex_m.hpp"

#include <cstdint>

namespace kfast::lm3s6965evb {
namespace {

constexpr std::uint32_t cycles_per_millisecond = system_hz / 1000;
constexpr std::uint32_t cycles_per_microsecond = system_hz / 1'000'000;

volatile std::uint32_t milliseconds = 0;

}

void Clock::begin()
{
    cortex_m::syst_rvr.write(cycles_per_millisecond - 1);
    cortex_m::syst_cvr.write(0);
    cortex_m::syst_csr.write(cortex_m::syst_csr_clksource | cortex_m::syst_csr_tickint |
                             cortex_m::syst_csr_enable);
}

Microseconds Clock::now() const
{
    std::uint32_t before = 0;
    std::uint32_t cycles_left = 0;
    do { // again if the tick came between the two readings
        before = milliseconds;
        cycles_left = cortex_m::syst_cvr.read();
    } while (before != milliseconds);
    return {before * 1000 + (cycles_per_millisecond - 1 - cycles_left) / cycles_per_microsecond};
}

void Clock::sleep_until(Microseconds moment) const
{
    while (!reached(now(), moment)) {
        if ((moment - now()).count > 1000)
            asm volatile("wfi");
    }
}

extern "C" void systick_handler() { milliseconds = milliseconds + 1; }

}
