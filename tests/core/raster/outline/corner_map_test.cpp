#include "core/raster/outline/contour_cache.hpp"

#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <numbers>
#include <random>

namespace kfast::raster::test {
namespace {

constexpr std::int32_t one = 1 << CornerMap::fraction_bits;

TEST_CASE("a map that does nothing leaves every corner where it is")
{
    const CornerMap map;
    for (const Corner corner : {Corner{0, 0}, Corner{-5, 7}, Corner{32767, -32768}, Corner{40000, -70000}})
        CHECK(map(corner) == corner);
}

TEST_CASE("shifts are rounded to the grid, halves to the right and down")
{
    constexpr std::int32_t unit = 1024; // of the grid, in 1/65536 px
    const auto shifted = [](std::int32_t x) { return CornerMap{one, 0, 0, one, x, -x}(Corner{10, 10}); };
    CHECK(shifted(3 * unit) == Corner{13, 7});
    CHECK(shifted(3 * unit + unit / 2) == Corner{14, 7});
    CHECK(shifted(3 * unit + unit / 2 - 1) == Corner{13, 7});
    CHECK(shifted(-unit / 2) == Corner{10, 11});
}

TEST_CASE("quarter turns and mirrors are exact")
{
    CHECK(CornerMap{0, -one, one, 0, 0, 0}(Corner{3, 5}) == Corner{-5, 3});
    CHECK(CornerMap{-one, 0, 0, one, 64 << 10, 0}(Corner{3, 5}) == Corner{61, 5});
}

TEST_CASE("corners lie where they are turned to, near and far")
{
    std::mt19937 random{29};
    for (int round = 0; round < 2000; ++round) {
        const auto part = [&random] { return static_cast<double>(random() % 1000) / 1000; };
        const double angle = 2 * std::numbers::pi * part();
        const double scale_factor = 0.5 + 0.56 * part();
        const auto factor = [scale_factor](double value) {
            return static_cast<std::int32_t>(std::lround(value * scale_factor * one));
        };
        const std::int32_t xx = factor(std::cos(angle));
        const std::int32_t yx = factor(std::sin(angle));
        const auto x0 = static_cast<std::int32_t>(random() % 100'000'000) - 50'000'000;
        const CornerMap map{xx, -yx, yx, xx, x0, -x0};
        const std::int32_t reach = random() % 2 == 0 ? 30'000 : 1'000'000;
        const auto coordinate = [&] {
            return static_cast<std::int32_t>(random() % 2'000'000) % (2 * reach) - reach;
        };
        const Corner from{coordinate(), coordinate()};
        const Corner to = map(from);
        const auto exact = [](double p, double a, double q, double b, double shift) {
            return (p * a + q * b) / one + shift / 1024;
        };
        CHECK(std::abs(to.x - exact(xx, from.x, -yx, from.y, x0)) <= 0.5001);
        CHECK(std::abs(to.y - exact(yx, from.x, xx, from.y, -x0)) <= 0.5001);
        if (is_short(from))
            CHECK(to ==
                  map(ShortCorner{static_cast<std::int16_t>(from.x), static_cast<std::int16_t>(from.y)}));
    }
}

}
}
