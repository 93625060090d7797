#include "boards/pico/beam/dac_program.hpp"
#include "firmware/settings/board_rules.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using namespace rp2040;
using pico::pio::point_clock;
using pico::pio::PointClock;

TEST_CASE("bits are never faster than asked for, and no slower than need be")
{
    const ClockRange range = clock_range(BusKind::dac);
    for (const std::uint32_t hz : {range.min, 1'000'000u, 1'234'567u, 3'906'250u, 12'500'000u, 17'857'143u,
                                   17'857'142u, 20'000'000u, range.max}) {
        const DacBit bit = dac_bit(hz);
        CHECK(default_hz <= std::uint64_t{hz} * bit.divisor * bit.cycles());
        CHECK(bit.divisor >= 1);
        CHECK(bit.divisor <= 65'535);
        CHECK(bit.low >= 2); // 16 ns, where an MCP4922 needs 15
        CHECK(bit.high >= 2);
        CHECK(bit.low <= 16);
        CHECK(bit.high <= 16);
    }
    CHECK(dac_bit(20'000'000).hz() == 17'857'142);
    CHECK(dac_bit(12'500'000).hz() == 12'500'000);
    CHECK(max_points(20'000'000) == 500'000);
}

TEST_CASE("the clock of the points counts every cycle")
{
    for (std::uint32_t cycles = 31; cycles <= 125'000; ++cycles) {
        const PointClock clock = point_clock(cycles);
        if (clock.cycles() != cycles || clock.rest < 1 || clock.rest > 16)
            FAIL(cycles);
    }
}

TEST_CASE("points come no faster than asked for")
{
    CHECK(cycles_per_point(100'000) == 1250);
    CHECK(cycles_per_point(30'000) == 4167);
    CHECK(cycles_per_point(1'000'000) == 125);
    CHECK(cycles_per_point(999) == 125'126);
}

TEST_CASE("both programs have room beside each other")
{
    constexpr auto dac_output = pico::pio::dac_output_program(dac_bit(20'000'000));
    constexpr auto clock = pico::pio::point_clock_program(point_clock(1250), dac_output.size());
    CHECK(dac_output.size() + clock.size() <= 32);
    CHECK((clock[3] & 0x1F) == dac_output.size() + 3); // goes round by itself
}

}
