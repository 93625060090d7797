#pragma once

#include "firmware/chip/register.hpp"

#include <cstdint>

/// The registers of a Cortex-M itself, at the same addresses in every chip. Names are those of ARM's
/// architecture manuals.
namespace kfast::cortex_m {

// SysTick: a timer of 24 bits that counts down. Writing the current value makes it zero.
inline constexpr Register syst_csr{0xE000'E010};
inline constexpr Register syst_rvr{0xE000'E014};
inline constexpr Register syst_cvr{0xE000'E018};
inline constexpr std::uint32_t syst_csr_enable = 1 << 0;
inline constexpr std::uint32_t syst_csr_tickint = 1 << 1;   ///< interrupts when it reaches zero
inline constexpr std::uint32_t syst_csr_clksource = 1 << 2; ///< counts cycles of the processor

// The interrupt controller: a bit for each of the first 32 interrupts; a 0 that is written changes nothing.
inline constexpr Register nvic_iser0{0xE000'E100};

// The system control block
inline constexpr Register icsr{0xE000'ED04};
inline constexpr std::uint32_t icsr_pendstclr = 1 << 25; ///< clears a pending SysTick interrupt
inline constexpr Register cpacr{0xE000'ED88};
inline constexpr std::uint32_t cpacr_fpu = 0xF << 20; ///< CP10 and CP11: full access

}
