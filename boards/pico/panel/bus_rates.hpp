#pragma once

#include "boards/pico/chip/clocks.hpp"

#include <cstdint>

/// How the units of the buses divide the system clock: always to the next rate that is no higher than asked.
namespace kfast::pico {

constexpr std::uint32_t divided_up(std::uint32_t dividend, std::uint32_t divisor)
{
    return (dividend + divisor - 1) / divisor;
}

/// The two dividers of an SPI unit, the second one more than its register says.
struct SpiRate {
    std::uint32_t prescale; ///< even, 2 … 254
    std::uint32_t divisor;  ///< 1 … 256

    constexpr std::uint32_t hz() const { return system_hz / (prescale * divisor); }
};

/// `hz` is within clock_range(BusKind::spi).
constexpr SpiRate spi_rate(std::uint32_t hz)
{
    const std::uint32_t cycles = divided_up(system_hz, hz);
    const std::uint32_t prescale = 2 * divided_up(cycles, 2 * 256);
    return {prescale, divided_up(cycles, prescale)};
}

/// The clock of an I²C unit, in its cycles.
struct I2cRate {
    std::uint32_t low;
    std::uint32_t high;

    constexpr std::uint32_t hz() const { return system_hz / (low + high); }
};

/// Low for 3/5 of the period, as fast mode (400 kHz: 1.3 µs of 2.5 µs) and fast mode plus need it.
/// `hz` is within clock_range(BusKind::i2c).
constexpr I2cRate i2c_rate(std::uint32_t hz)
{
    const std::uint32_t cycles = divided_up(system_hz, hz);
    const std::uint32_t low = cycles * 3 / 5;
    return {low, cycles - low};
}

/// A write on the parallel bus: the data pins change, WR falls, WR rises and the data is taken. In cycles of
/// the state machine, each of which takes `divisor` cycles of the system.
struct WriteCycle {
    static constexpr std::uint32_t shortest = 9; ///< 72 ns, where panels need 66
    static constexpr std::uint32_t longest = 32; ///< with what the delays of three instructions hold

    std::uint32_t divisor; ///< 1 … 65535
    std::uint32_t setup;   ///< data is there, WR still high
    std::uint32_t low;     ///< WR low
    std::uint32_t hold;    ///< WR high again, data still there

    constexpr std::uint32_t cycles() const { return setup + low + hold; }
    constexpr std::uint32_t hz() const { return system_hz / (divisor * cycles()); }
};

/// The shortest has WR low for 32 ns and high for 40 ns, 24 of them with the data that was taken.
/// `hz` is within clock_range(BusKind::parallel_8).
constexpr WriteCycle write_cycle(std::uint32_t hz)
{
    const std::uint32_t system_cycles = divided_up(system_hz, hz);
    const std::uint32_t divisor = divided_up(system_cycles, WriteCycle::longest);
    std::uint32_t cycles = divided_up(system_cycles, divisor);
    if (cycles < WriteCycle::shortest)
        cycles = WriteCycle::shortest;
    const std::uint32_t low = cycles / 2;
    const std::uint32_t setup = (cycles - low) / 2;
    return {divisor, setup, low, cycles - low - setup};
}

}
