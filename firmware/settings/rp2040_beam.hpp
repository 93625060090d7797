#pragma once

#include <cstdint>

/// How an RP2040 at its default clock paces the points of a beam and sends each to an MCP4922: two words of
/// 16 bits, and a pulse on LDAC at which both its converters take over.
///
/// The limits are those of the data sheet (Microchip DS22250A, page 7): clock high and low for
/// 15 ns each, no faster than 20 MHz, and low for 40 ns before CS falls; CS high for 15 ns; LDAC 40 ns after
/// CS, low for 100 ns.
namespace kfast::rp2040 {

/// The clock of the processor and the state machines, Hz.
inline constexpr std::uint32_t default_hz = 125'000'000;

/// One bit sent to the converters, in cycles of the state machine, each of which takes `divisor` cycles of
/// the chip.
struct DacBit {
    static constexpr std::uint32_t longest = 32; ///< what the delays of two instructions hold

    std::uint32_t divisor; ///< 1 … 65535
    std::uint32_t low;     ///< the data changes at its beginning
    std::uint32_t high;    ///< the data is taken at its beginning

    constexpr std::uint32_t cycles() const { return low + high; }
    constexpr std::uint32_t hz() const { return default_hz / (divisor * cycles()); }
};

/// The next one that is no faster than `hz`, which is within clock_range(BusKind::dac).
constexpr DacBit dac_bit(std::uint32_t hz)
{
    const std::uint32_t chip_cycles = (default_hz + hz - 1) / hz;
    const std::uint32_t divisor = (chip_cycles + DacBit::longest - 1) / DacBit::longest;
    const std::uint32_t cycles = (chip_cycles + divisor - 1) / divisor;
    return {divisor, cycles - cycles / 2, cycles / 2};
}

/// What it takes to send a point, in cycles of the chip: 32 bits, and what the state machine does between
/// them (boards/pico/beam/dac_program.hpp).
constexpr std::uint32_t cycles_to_send(const DacBit& bit)
{
    constexpr std::uint32_t between = 20;
    constexpr std::uint32_t of_point_clock = 6;
    return bit.divisor * (32 * bit.cycles() + between) + of_point_clock;
}

/// From point to point, so that no more than `rate` are shown in a second. `rate` is not 0.
constexpr std::uint32_t cycles_per_point(std::uint32_t rate) { return (default_hz + rate - 1) / rate; }

/// Points in a second that the wires can carry.
constexpr std::uint32_t max_points(std::uint32_t bus_clock)
{
    return default_hz / cycles_to_send(dac_bit(bus_clock));
}

}
