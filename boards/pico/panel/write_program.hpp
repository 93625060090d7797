#pragma once

#include "boards/pico/chip/pio_instructions.hpp"
#include "boards/pico/panel/bus_rates.hpp"

#include <array>
#include <cstdint>

/// Instructions for a state machine of the PIO that writes bytes to an 8080 bus. Its side-set pin is WR.
namespace kfast::pico::pio {

/// Loops. It waits for data at the first instruction, where WR is high: the bus is idle as displays require,
/// and the byte before has been taken.
constexpr std::array<std::uint32_t, 3> write_program(const WriteCycle& cycle)
{
    return {
        out_pins_8 | side_1 | lasting(cycle.setup),
        nop | side_0 | lasting(cycle.low),
        nop | side_1 | lasting(cycle.hold),
    };
}

}
