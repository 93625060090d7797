#include "core/math/affine.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

/// Anything up to 2^bits in size; small numbers are as likely as large ones.
std::int64_t random_number(std::mt19937_64& random, int bits)
{
    const auto number =
        static_cast<std::int64_t>(random() >> 1 >> (63 - random() % static_cast<unsigned>(bits + 1)));
    return random() % 2 == 0 ? number : -number;
}

std::int32_t factor(std::mt19937_64& random, int bits)
{
    return static_cast<std::int32_t>(random_number(random, bits));
}

Point point(std::mt19937_64& random, int bits)
{
    const Fixed x = Fixed::from_raw(factor(random, bits));
    return {x, Fixed::from_raw(factor(random, bits))};
}

}

TEST_CASE("a map made ready gives the same bits, for shifts, small factors and large ones")
{
    std::mt19937_64 random{31};
    for (int round = 0; round < rounds(20'000); ++round) {
        const int bits = round % 2 == 0 ? 19 : 28;
        Affine map;
        if (round % 3 != 0)
            map = {factor(random, bits), factor(random, bits), factor(random, bits), factor(random, bits)};
        map.x0 = random_number(random, round % 5 == 0 ? 40 : 30);
        map.y0 = random_number(random, round % 5 == 0 ? 40 : 30);
        const PointMap ready{map};
        for (int i = 0; i < 50; ++i) {
            const Point at = point(random, i % 2 == 0 ? 26 : 30);
            REQUIRE(ready(at) == map(at));
        }
    }
}

TEST_CASE("at the ends of the ranges of the fast ways, the bits are the same")
{
    for (const std::int32_t size : {(1 << 19) - 1, 1 << 19, -(1 << 19) + 1, Fixed::one, 0})
        for (const std::int64_t shift : {std::int64_t{8191} << 16, (std::int64_t{8191} << 16) - 1,
                                         -(std::int64_t{8191} << 16) + 1, std::int64_t{1} << 29}) {
            const Affine map{size, -size, size, size, shift, -shift};
            const PointMap ready{map};
            const Affine shifting{.x0 = shift, .y0 = -shift};
            const PointMap shifts{shifting};
            for (const std::int32_t reach : {(1 << 26) - 1, 1 << 26, (1 << 29) - 1, (8191 << 16) - 1})
                for (const Point at : {Point{Fixed::from_raw(reach), Fixed::from_raw(reach)},
                                       Point{Fixed::from_raw(-reach), Fixed::from_raw(reach)}}) {
                    CHECK(ready(at) == map(at));
                    CHECK(shifts(at) == shifting(at));
                }
        }
}

}
