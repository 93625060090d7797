#pragma once

#include "firmware/chip/cortex_m.hpp"

#include <cstdint>

/// The CPU's own timer: 24 bits, counting down.
namespace kfast::bench::systick {

inline constexpr std::uint32_t mask = 0xFF'FFFF;

enum class Interrupt : std::uint32_t {
    off = cortex_m::syst_csr_clksource | cortex_m::syst_csr_enable,
    on = off | cortex_m::syst_csr_tickint,
};

/// Counts `period` ticks down, again and again.
inline void start(std::uint32_t period, Interrupt interrupt)
{
    cortex_m::syst_rvr.write(period - 1);
    cortex_m::syst_cvr.write(0);
    cortex_m::syst_csr.write(static_cast<std::uint32_t>(interrupt));
}

/// No interrupt comes any more.
inline void stop()
{
    cortex_m::syst_csr.write(0);
    cortex_m::icsr.write(cortex_m::icsr_pendstclr);
}

inline std::uint32_t value() { return cortex_m::syst_cvr.read(); }

}
