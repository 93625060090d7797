#include "core/pixel/pixel_row.hpp"

#include <doctest/doctest.h>

#include <bit>

namespace kfast::test {
namespace {

int lit_of_64(std::uint32_t brightness)
{
    int lit = 0;
    for (int y = 0; y < 8; ++y)
        lit += std::popcount(dither.eight(brightness, y));
    return lit;
}

}

TEST_CASE("as many pixels are lit as the brightness says, to the nearest 64th")
{
    for (int brightness = 0; brightness <= 255; ++brightness)
        CHECK(lit_of_64(static_cast<std::uint32_t>(brightness)) == (brightness * 64 * 2 + 255) / (2 * 255));
}

TEST_CASE("the pattern is Bayer's and repeats every eight pixels")
{
    // A quarter is every other pixel of every other row, a half is a chequerboard.
    CHECK(dither.eight(64, 0) == 0b10101010);
    CHECK(dither.eight(64, 1) == 0);
    CHECK(dither.eight(128, 0) == 0b10101010);
    CHECK(dither.eight(128, 1) == 0b01010101);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            CHECK(dither.is_lit(100, x + 64, y + 24) == dither.is_lit(100, x, y));
}

TEST_CASE("a pixel that is lit stays lit when it gets brighter")
{
    for (int y = 0; y < 8; ++y)
        for (std::uint32_t brightness = 0; brightness < 255; ++brightness)
            REQUIRE((dither.eight(brightness, y) & ~dither.eight(brightness + 1, y)) == 0);
}

}
