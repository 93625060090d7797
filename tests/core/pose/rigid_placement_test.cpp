#include "core/pose/item_state.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

std::int32_t q16(double value) { return static_cast<std::int32_t>(std::lround(value * Fixed::one)); }

Affine turned(double degrees, double scale_factor, bool is_mirrored = false)
{
    const double angle = degrees * 3.14159265358979 / 180;
    const double sign = is_mirrored ? -1 : 1;
    return {.xx = q16(std::cos(angle) * scale_factor),
            .xy = q16(-std::sin(angle) * scale_factor * sign),
            .yx = q16(std::sin(angle) * scale_factor),
            .yy = q16(std::cos(angle) * scale_factor * sign),
            .x0 = q16(100),
            .y0 = q16(-7.3)};
}

TEST_CASE("what is only turned keeps the scale of the canvas")
{
    for (const double canvas : {1.0, 1.3333, 0.7, 2.0, 3.9})
        for (int degrees = 0; degrees < 360; ++degrees) {
            const auto placement = RigidPlacements{q16(canvas)}.of(turned(degrees, canvas));
            REQUIRE(placement);
            CHECK(placement->scale_bits == 0);
            CHECK(std::abs(placement->scale - q16(canvas)) < 16);
        }
}

TEST_CASE("the scale is that of the octave, and not finer than needed")
{
    const auto bits = [](double scale_factor) {
        const auto placement = RigidPlacements{}.of(turned(30, scale_factor));
        return placement ? placement->scale_bits : 99;
    };
    CHECK(bits(1.06) == 0);
    CHECK(bits(1.07) == 1);
    CHECK(bits(0.54) == 0);
    CHECK(bits(0.53) == -1);
    CHECK(bits(2.1) == 1);
    CHECK(bits(4.2) == 2);
    CHECK(bits(16.9) == 4);
    CHECK(bits(17.1) == 99);
    CHECK(bits(0.001) == -4);
}

TEST_CASE("what is sheared, squashed or far away is not rigid")
{
    const RigidPlacements placements;
    CHECK_FALSE(placements.of({.xx = q16(1.1)}));
    CHECK_FALSE(placements.of({.xy = q16(0.1)}));
    CHECK_FALSE(placements.of({.x0 = std::int64_t{9000} * Fixed::one}));
    CHECK_FALSE(placements.of({.xx = Affine::max_factor, .yy = Affine::max_factor}));
    CHECK_FALSE(placements.of({.xx = -Affine::max_factor, .yy = -Affine::max_factor}));
    CHECK(placements.of({.x0 = std::int64_t{8000} * Fixed::one}));
    CHECK(placements.of({.xx = -Fixed::one}));              // a mirror
    const RigidPlacements of_one_pixel{Affine::max_factor}; // on 4096
    CHECK(of_one_pixel.of({.xx = Affine::max_factor, .yy = Affine::max_factor}));
    CHECK_FALSE(
        RigidPlacements{Affine::max_factor / 2}.of({.xx = Affine::max_factor, .yy = Affine::max_factor / 2}));
    CHECK(RigidPlacements{Affine::max_factor / 2}.of({.xx = Affine::max_factor, .yy = Affine::max_factor}));
}

TEST_CASE("corners are placed where the map places points")
{
    std::mt19937 random{31};
    for (int round = 0; round < 3000; ++round) {
        const auto part = [&random] { return static_cast<double>(random() % 1000) / 1000; };
        const double canvas = round % 2 == 0 ? 1 : 0.3 + 3 * part();
        const double scale_factor = canvas * (0.07 + 4 * part());
        const Affine map = turned(360 * part(), scale_factor, random() % 2 == 0);
        const auto placement = RigidPlacements{q16(canvas)}.of(map);
        REQUIRE(placement);
        const Point at{Fixed::from_raw(static_cast<std::int32_t>(random() % (200 << 16))),
                       Fixed::from_raw(static_cast<std::int32_t>(random() % (200 << 16)))};
        const raster::Corner placed = placement->map(raster::corner_at(placement->upright()(at)));
        const raster::Corner direct = raster::corner_at(map(at));
        const double reach =
            200.0 * raster::grid * std::max(placement->scale, q16(scale_factor)) / Fixed::one;
        const double max = 1.5 + 2 * reach / (1 << 15); // both factors are rounded, too
        CHECK(std::abs(placed.x - direct.x) <= max);
        CHECK(std::abs(placed.y - direct.y) <= max);
    }
}

}
}
