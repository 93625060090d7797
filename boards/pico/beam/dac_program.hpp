#pragma once

#include "boards/pico/chip/pio_instructions.hpp"
#include "firmware/settings/rp2040_beam.hpp"

#include <array>
#include <cstdint>

/// Two state machines lead the beam. One tells the converters each point, the other is the clock of the
/// points: it counts cycles and waits for nobody, so that from LDAC to LDAC there is always the same time.
/// That is why no timer of the DMA paces the points: a transfer waits for the bus, a count does not.
namespace kfast::pico::pio {

/// Tells the converters a point whenever the clock of the points has set flag 0. Its side-set pin is the
/// clock of the bits, its out pin their data, its set pin CS. A word holds, from the highest bits on, 8 bits
/// that are 0 if the beam is dark, 12 of x, 12 of y. Where no word has come it takes the one in ISR.
///
/// When both words are told, the data line is high if the beam is to be dark: the clock of the points copies
/// it.
constexpr std::array<std::uint32_t, 25> dac_output_program(const rp2040::DacBit& bit)
{
    constexpr std::uint32_t cs_to_clock = 2; // and the low half of a bit: 40 ns in all, which mode 1,1 needs
    constexpr std::uint32_t rest_of_clock = 5; // low for 40 ns before CS falls
    const std::uint32_t low = side_low | lasting(bit.low);
    const std::uint32_t high = side_high | lasting(bit.high);
    return {
        wait_for_flag_0 | side_low,
        mov_x_isr | side_low,
        pull_or_x | side_low,
        out_y_8 | side_low,
        // 0111 and x: to converter A, its reference buffered, gain 1, on.
        set_pins(0) | side_low | lasting(cs_to_clock),
        mov_pins_zeros | low,
        set_x(3 - 1) | high,
        /* 7 */ mov_pins_ones | low,
        jump_while_x_counts_down(7) | high,
        set_x(12 - 1) | side_low,
        /* 10 */ out_pins_1 | low,
        jump_while_x_counts_down(10) | high,
        set_pins(1) | side_low | lasting(rest_of_clock),
        // 1111 and y: to converter B.
        set_pins(0) | side_low | lasting(cs_to_clock),
        set_x(4 - 1) | side_low,
        /* 15 */ mov_pins_ones | low,
        jump_while_x_counts_down(15) | high,
        set_x(12 - 1) | side_low,
        /* 18 */ out_pins_1 | low,
        jump_while_x_counts_down(18) | high,
        set_pins(1) | side_low,
        jump_if_not_y(24) | side_low,
        mov_pins_zeros | side_low,
        jump(0) | side_low,
        /* 24 */ mov_pins_ones | side_low,
    };
}

/// How often the clock of the points goes round a loop, less one, and how long it waits besides.
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

/// The converters take over what they were told, and the beam is as bright as it shall be there. Its side-set
/// pin is LDAC, its out pin makes the beam dark, its in pin is the data line. y holds the turns. It lies at
/// `place`.
constexpr std::array<std::uint32_t, 4> point_clock_program(const PointClock& clock, std::uint32_t place)
{
    return {
        mov_pins_pins | side_low,
        set_flag_0 | side_low | lasting(PointClock::latch - 1),
        mov_x_y | side_high | lasting(clock.rest),
        jump_while_x_counts_down(place + 3) | side_high | lasting(PointClock::turn),
    };
}

}
