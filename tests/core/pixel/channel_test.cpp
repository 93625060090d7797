#include "core/pixel/paint_style.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a product of two bytes is divided to the nearest 255th, for all products")
{
    for (std::uint32_t product = 0; product <= 255 * 255; ++product)
        REQUIRE(rounded_255th(product) == (product + 127) / 255);
}

TEST_CASE("channels are narrowed and widened to the nearest value, and come back")
{
    for (const std::uint32_t max : {1U, 15U, 31U, 63U, 255U}) {
        for (std::uint32_t value = 0; value <= 255; ++value)
            REQUIRE(std::abs(narrow_channel(value, max) - value * max / 255.0) <= 0.5);
        for (std::uint32_t value = 0; value <= max; ++value) {
            REQUIRE(std::abs(widen_channel(value, max) - value * 255.0 / max) <= 0.5);
            REQUIRE(narrow_channel(widen_channel(value, max), max) == value);
        }
    }
}

TEST_CASE("a blend is the nearest value on the way from under to over")
{
    for (std::uint32_t coverage = 0; coverage <= 255; ++coverage)
        for (std::uint32_t under = 0; under <= 255; under += 5)
            for (std::uint32_t over = 0; over <= 255; over += 3) {
                const double exact = under + (static_cast<double>(over) - under) * coverage / 255;
                REQUIRE(std::abs(blend_channel(under, over, coverage) - exact) <= 0.5);
            }
}

TEST_CASE("two channels are blended as each on its own, whatever the other is")
{
    constexpr std::array ends{0U, 1U, 31U, 254U, 255U};
    for (std::uint32_t coverage = 0; coverage <= 255; ++coverage)
        for (std::uint32_t under = 0; under <= 255; under += 5)
            for (const std::uint32_t over : ends)
                for (const std::uint32_t other_under : ends)
                    for (const std::uint32_t other_over : ends) {
                        const std::uint32_t high = blend_channel(under, over, coverage);
                        const std::uint32_t low = blend_channel(other_under, other_over, coverage);
                        REQUIRE(blend_two_channels(under << 16 | other_under, over << 16 | other_over,
                                                   coverage) == (high << 16 | low));
                    }
}

TEST_CASE("brightness runs from black to white")
{
    CHECK(brightness({0, 0, 0}) == 0);
    CHECK(brightness({255, 255, 255}) == 255);
    CHECK(brightness({255, 0, 0}) == 77);
    CHECK(brightness({0, 255, 0}) == 149);
    CHECK(brightness({0, 0, 255}) == 29);
}

}
