#pragma once

#include "boards/pico/chip/pio_instructions.hpp"
#include "firmware/settings/rp2040_beam.hpp"

#include <array>
#include <cstdint>

/// Two state machines move the beam. One sends each point to the converters, the other is the clock of the
/// points: it counts cycles and never waits, so that from LDAC to LDAC there is always the same time.
/// That is why no timer of the DMA paces the points: a transfer waits for the bus, a count does not.
namespace kfast::pico::pio {

/// Sends a point to the converters whenever the clock of the points has set flag 0. Its side-set pin is the
/// clock of the bits, its out pin their data, its set pin CS. A word holds, from the highest bits on, 8 bits
/// that are 0 if the beam is dark, 12 of x, 12 of y. Where no word has come it takes the one in ISR.
///
/// When both words are sent, the data line is high if the beam is to be dark: the clock of the points copies
/// it.
constexpr std::array<std::uint32_t, 25> dac_output_program(const rp2040::DacBit& bit)
{
    constexpr std::uint32_t cs_to_clock = 2; // and the low half of a bit: 40 ns in all, which mode 1,1 needs
    constexpr std::uint32_t rest_of_clock = 5; // low for 40 ns before CS falls
    const std::uint32_t low = side_0 | lasting(bit.low);
    const std::uint32_t high = side_1 | lasting(bit.high);
    return {
        wait_irq_0 | side_0,
        mov_x_isr | side_0,
        pull_noblock | side_0,
        out_y_8 | side_0,
        // 0111 and x: to converter A, its reference buffered, gain 1, on.
        set_pins(0) | side_0 | lasting(cs_to_clock),
        mov_pins_null | low,
        set_x(3 - 1) | high,
        /* 7 */ mov_pins_not_null | low,
        jmp_x_dec(7) | high,
        set_x(12 - 1) | side_0,
        /* 10 */ out_pins_1 | low,
        jmp_x_dec(10) | high,
        set_pins(1) | side_0 | lasting(rest_of_clock),
        // 1111 and y: to converter B.
        set_pins(0) | side_0 | lasting(cs_to_clock),
        set_x(4 - 1) | side_0,
        /* 15 */ mov_pins_not_null | low,
        jmp_x_dec(15) | high,
        set_x(12 - 1) | side_0,
        /* 18 */ out_pins_1 | low,
        jmp_x_dec(18) | high,
        set_pins(1) | side_0,
        jmp_not_y(24) | side_0,
        mov_pins_null | side_0,
        jmp(0) | side_0,
        /* 24 */ mov_pins_not_null | side_0,
    };
}

/// How often the clock of the points runs a loop, less one, and how long it waits besides.
struct PointClock {
    static constexpr std::uint32_t latch = 14; ///< LDAC is low for 112 ns
    static constexpr std::uint32_t turn = 16;

    std::uint32_t turns; ///< 0 …
    std::uint32_t rest;  ///< 1 … 16 cycles

    constexpr std::uint32_t cycles() const { return latch + rest + turn * (turns + 1); }
};

/// `cycles` is at least 31.
constexpr PointClock point_clock(std::uint32_t cycles)
{
    const std::uint32_t left = cycles - PointClock::latch - 1;
    return {left / PointClock::turn - 1, left % PointClock::turn + 1};
}

/// The converters take over what they were sent, and the beam is as bright as it should be there. Its
/// side-set pin is LDAC, its out pin makes the beam dark, its in pin is the data line. y holds the turns. It
/// is loaded at `place`.
constexpr std::array<std::uint32_t, 4> point_clock_program(const PointClock& clock, std::uint32_t place)
{
    return {
        mov_pins_pins | side_0,
        irq_set_0 | side_0 | lasting(PointClock::latch - 1),
        mov_x_y | side_1 | lasting(clock.rest),
        jmp_x_dec(place + 3) | side_1 | lasting(PointClock::turn),
    };
}

}
