#include "core/math/fixed.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <random>

namespace kfast::test {

TEST_CASE("a ratio is rounded to nearest, whichever way it is computed")
{
    for (const std::uint32_t denominator :
         {1U, 2U, 3U, 7U, 1024U, 40'000U, 1'024'000'000U, 2'147'483'647U, 4'294'967'295U}) {
        std::mt19937 random{71};
        for (int round = 0; round < 2'000; ++round) {
            const auto numerator = static_cast<std::uint32_t>(random() % (std::uint64_t{denominator} + 1));
            const double exact = numerator * 65536.0 / denominator;
            REQUIRE(std::abs(Fraction::ratio(numerator, denominator).raw - exact) <= 0.5);
        }
        CHECK(Fraction::ratio(0, denominator).raw == 0);
        CHECK(Fraction::ratio(denominator, denominator).raw == Fraction::one);
    }
}

TEST_CASE("ratios never fall as their numerator rises")
{
    for (std::uint32_t numerator = 1; numerator <= 40'000; ++numerator)
        REQUIRE(Fraction::ratio(numerator - 1, 40'000) <= Fraction::ratio(numerator, 40'000));
}

TEST_CASE("lerp is exact at both ends and rounds halves up between them")
{
    const Fixed a = Fixed::from_raw(-7);
    const Fixed b = Fixed::from_raw(4);
    CHECK(lerp(a, b, Fraction{0}) == a);
    CHECK(lerp(a, b, Fraction{Fraction::one}) == b);
    CHECK(lerp(a, b, Fraction{Fraction::one / 2}).raw() == -1); // -1.5
    CHECK(lerp(Fixed::sixteenths(-32768), Fixed::sixteenths(32767), Fraction{Fraction::one}) ==
          Fixed::sixteenths(32767));
}

TEST_CASE("a way leads from a to b, and beyond")
{
    const Fixed a = Fixed::from_raw(-7);
    const Fixed b = Fixed::from_raw(4);
    CHECK(lerp(a, b, Progress{0}) == a);
    CHECK(lerp(a, b, Progress{Progress::one}) == b);
    CHECK(lerp(a, b, Progress{Progress::one / 2}).raw() == -1); // -1.5
    CHECK(lerp(a, b, Progress{2 * Progress::one}).raw() == 15);
    CHECK(lerp(a, b, Progress{-Progress::one / 2}).raw() == -12); // -12.5
    const Fixed min = Fixed::sixteenths(-32768);
    const Fixed max = Fixed::sixteenths(32767);
    CHECK(lerp(min, max, Progress{Progress::one * 5 / 2}).raw() ==
          Fixed::pixels(8192).raw() - 65536 * 5 / 32);
    CHECK(lerp(max, min, Progress{Progress::one * 5 / 2}).raw() ==
          65536 * 3 / 32 - Fixed::pixels(8192).raw());
}

TEST_CASE("32-bit steps multiply as 64 bits do")
{
    std::mt19937 random{72};
    const auto check = [](std::int32_t value, std::int32_t factor) {
        const std::int64_t exact = (std::int64_t{value} * factor + 32768) >> 16;
        if (exact == static_cast<std::int32_t>(exact))
            REQUIRE(multiply_q16(value, factor) == exact);
    };
    for (int round = 0; round < rounds(1'000'000); ++round)
        check(static_cast<std::int32_t>(random()) >> random() % 32,
              static_cast<std::int32_t>(random()) >> random() % 32);
    constexpr std::int32_t max = std::numeric_limits<std::int32_t>::max();
    constexpr std::int32_t min = std::numeric_limits<std::int32_t>::min();
    for (const std::int32_t value : {max, min, 65535, -65535, 65536, -65536, 0x7FFFFFFF - 32768, 1, -1, 0})
        for (const std::int32_t factor :
             {65536, -65536, 65535, 1, 0, -1, 32768, -32768, max, min, 163840, -98304})
            check(value, factor);
}

TEST_CASE("the square root is the whole part of the exact one")
{
    for (const std::uint32_t root : {0U, 1U, 2U, 255U, 256U, 46'340U, 65'534U, 65'535U}) {
        CHECK(square_root(root * root) == root);
        CHECK(square_root(root * root + 2 * root) == root);
        if (root > 0)
            CHECK(square_root(root * root - 1) == root - 1);
    }
    CHECK(square_root(0xFFFFFFFF) == 65'535);
}

TEST_CASE("a distribution gives the remainder to the first")
{
    constexpr Distribution eleven_over_four{11, 4};
    CHECK(eleven_over_four.at(0) == 3);
    CHECK(eleven_over_four.at(2) == 3);
    CHECK(eleven_over_four.at(3) == 2);
}

}
