#include "boards/pico/panel/write_program.hpp"

#include <doctest/doctest.h>

namespace kfast::pico::test {

TEST_CASE("a write is three instructions: data and WR high, WR low, WR high")
{
    const auto program = pio::write_program({.divisor = 1, .setup = 2, .low = 4, .hold = 3});
    CHECK(program[0] == 0x7108); // out pins, 8  side 1 [1]
    CHECK(program[1] == 0xA342); // nop          side 0 [3]
    CHECK(program[2] == 0xB242); // nop          side 1 [2]
}

TEST_CASE("the longest delays stay out of the side-set bit")
{
    const auto program = pio::write_program({.divisor = 1, .setup = 16, .low = 16, .hold = 16});
    CHECK(program[0] == 0x7F08);
    CHECK(program[1] == 0xAF42);
    CHECK(program[2] == 0xBF42);
}

}
