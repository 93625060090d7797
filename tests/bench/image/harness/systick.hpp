#pragma once

#include <cstdint>

/// The CPU's own timer: 24 bits, counting down.
namespace kfast::bench::systick {

inline constexpr std::uint32_t mask = 0xFF'FFFF;

enum class Interrupt : std::uint32_t { off = 5, on = 7 };

inline volatile std::uint32_t& at(std::uint32_t address)
{
    return *reinterpret_cast<volatile std::uint32_t*>(address);
}

/// Counts `period` ticks down, again and again.
inline void start(std::uint32_t period, Interrupt interrupt)
{
    at(0xE000'E014) = period - 1;
    at(0xE000'E018) = 0;
    at(0xE000'E010) = static_cast<std::uint32_t>(interrupt);
}

/// No interrupt comes any more.
inline void stop()
{
    at(0xE000'E010) = 0;
    at(0xE000'ED04) = 1 << 25;
}

inline std::uint32_t value() { return at(0xE000'E018); }

}
