#pragma once

#include "boards/pico/bus_rates.hpp"

#include <array>
#include <cstdint>

/// Instructions for a state machine of the PIO that writes bytes to an 8080 bus. Its side-set pin is WR.
namespace kfast::pico::pio {

inline constexpr std::uint32_t side_low = 0 << 12;
inline constexpr std::uint32_t side_high = 1 << 12;

inline constexpr std::uint32_t out_pins_8 = 0x6008;
inline constexpr std::uint32_t no_operation = 0xA042; // mov y, y

/// The instruction takes so many cycles, 1 … 16.
constexpr std::uint32_t lasting(std::uint32_t cycles) { return (cycles - 1) << 8; }

/// Loops. It waits for data at the first instruction, where WR is high: the bus stands still as displays like
/// it, and the byte before has been taken.
constexpr std::array<std::uint32_t, 3> write_program(const WriteCycle& cycle)
{
    return {
        out_pins_8 | side_high | lasting(cycle.setup),
        no_operation | side_low | lasting(cycle.low),
        no_operation | side_high | lasting(cycle.hold),
    };
}

// For once, before the loop; without side-set but for the last.
inline constexpr std::uint32_t set_pins_1 = 0xE001;
inline constexpr std::uint32_t set_directions_1 = 0xE081;
inline constexpr std::uint32_t mov_osr_ones = 0xA0EB; // mov osr, ~null
inline constexpr std::uint32_t out_directions_8 = 0x6088;
inline constexpr std::uint32_t jump_to_0 = 0x0000;

}
