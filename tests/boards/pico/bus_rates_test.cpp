#include "boards/pico/panel/bus_rates.hpp"

#include "firmware/settings/board_rules.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::pico::test {

namespace {

/// Clocks from the slowest to the fastest that a bus may have, both ends included.
std::vector<std::uint32_t> clocks_of(BusKind bus)
{
    const ClockRange range = clock_range(bus);
    std::vector<std::uint32_t> clocks;
    for (std::uint64_t hz = range.min; hz < range.max; hz += hz / 1000 + 1)
        clocks.push_back(static_cast<std::uint32_t>(hz));
    clocks.push_back(range.max);
    return clocks;
}

/// Whether `cycles` of the system are a period no shorter than that of `hz`.
bool is_no_faster(std::uint64_t cycles, std::uint32_t hz) { return cycles * hz >= system_hz; }

}

TEST_CASE("SPI is halved, or divided by more than was asked")
{
    CHECK(spi_rate(62'500'000).hz() == 62'500'000);
    CHECK(spi_rate(62'499'999).hz() == 31'250'000);
    CHECK(spi_rate(10'000'000).hz() == 8'928'571);
    CHECK(spi_rate(1'000'000).hz() == 992'063);
}

TEST_CASE("dividers of SPI fit their registers and never make a faster clock")
{
    for (const std::uint32_t hz : clocks_of(BusKind::spi)) {
        const SpiRate rate = spi_rate(hz);
        CAPTURE(hz);
        REQUIRE(rate.prescale % 2 == 0);
        REQUIRE((rate.prescale >= 2 && rate.prescale <= 254));
        REQUIRE((rate.divisor >= 1 && rate.divisor <= 256));
        REQUIRE(is_no_faster(rate.prescale * rate.divisor, hz));
        REQUIRE(rate.prescale * rate.divisor < system_hz / hz + 1 + rate.prescale);
    }
}

TEST_CASE("I2C has SCL low and high for as long as each mode asks")
{
    CHECK(i2c_rate(400'000).low == 187); // 1496 ns of 1300
    CHECK(i2c_rate(400'000).high == 126);
    CHECK(i2c_rate(1'000'000).low == 75); // 600 ns of 500
    CHECK(i2c_rate(1'000'000).high == 50);
    for (const std::uint32_t hz : clocks_of(BusKind::i2c)) {
        const I2cRate rate = i2c_rate(hz);
        CAPTURE(hz);
        REQUIRE((rate.low <= 65'536 && rate.high <= 65'535));
        REQUIRE(is_no_faster(rate.low + rate.high, hz));
        REQUIRE(rate.low + rate.high == (system_hz + hz - 1) / hz);
    }
}

TEST_CASE("a write on the parallel bus takes 72 ns at least, low for 32 and high for 40")
{
    const WriteCycle cycle = write_cycle(15'151'515);
    CHECK(cycle.divisor == 1);
    CHECK(cycle.low == 4);
    CHECK(cycle.setup == 2);
    CHECK(cycle.hold == 3);
    CHECK(cycle.hz() == 13'888'888);
}

TEST_CASE("slower writes last longer in all their parts")
{
    CHECK(write_cycle(10'000'000).cycles() == 13);
    CHECK(write_cycle(4'000'000).cycles() == 32);
    CHECK(write_cycle(4'000'000).divisor == 1);
    CHECK(write_cycle(3'900'000).cycles() == 17);
    CHECK(write_cycle(3'900'000).divisor == 2);
    for (const std::uint32_t hz : clocks_of(BusKind::parallel_8)) {
        const WriteCycle cycle = write_cycle(hz);
        CAPTURE(hz);
        REQUIRE((cycle.divisor >= 1 && cycle.divisor <= 65'535));
        REQUIRE((cycle.setup >= 2 && cycle.setup <= 16));
        REQUIRE((cycle.low >= 4 && cycle.low <= 16));
        REQUIRE((cycle.hold >= 2 && cycle.hold <= 16));
        REQUIRE(cycle.setup + cycle.hold >= 4);
        REQUIRE(is_no_faster(std::uint64_t{cycle.divisor} * cycle.cycles(), hz));
    }
}

}
