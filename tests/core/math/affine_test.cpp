#include "core/math/affine.hpp"

#include "tests/core/array_drawing.hpp"

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

std::int32_t q16(double value) { return static_cast<std::int32_t>(std::lround(value * 65536)); }

double apart(Point a, Point b) { return std::hypot((a.x - b.x).raw(), (a.y - b.y).raw()) / 65536.0; }

Affine random_map(std::mt19937& random)
{
    std::uniform_real_distribution<double> factor{-3, 3};
    std::uniform_real_distribution<double> shift{-300, 300};
    return {q16(factor(random)), q16(factor(random)), q16(factor(random)),
            q16(factor(random)), q16(shift(random)),  q16(shift(random))};
}

}

TEST_CASE("the map without numbers changes nothing")
{
    CHECK(Affine{}(pixels(-12.25, 700)) == pixels(-12.25, 700));
    CHECK(Affine{} * Affine{} == Affine{});
    CHECK(Affine{}.scale_factor() == Fixed::one);
}

TEST_CASE("rows and columns of the matrix are where they should be")
{
    const Affine map{.xx = q16(2), .xy = q16(3), .yx = q16(5), .yy = q16(7), .x0 = q16(11), .y0 = q16(13)};
    CHECK(map(pixels(1, 10)) == pixels(2 + 30 + 11, 5 + 70 + 13));
}

TEST_CASE("a product maps by the inner map first")
{
    const Affine wider{.xx = q16(2), .yy = q16(2)};
    const Affine moved{.x0 = q16(10)};
    CHECK((wider * moved)(pixels(1, 0)) == pixels(22, 0));
    CHECK((moved * wider)(pixels(1, 0)) == pixels(12, 0));
    std::mt19937 random{3};
    for (int round = 0; round < 1000; ++round) {
        const Affine outer = random_map(random);
        const Affine inner = random_map(random);
        const Point point =
            pixels(static_cast<int>(random() % 400) - 200, static_cast<int>(random() % 400) - 200);
        CHECK(apart((outer * inner)(point), outer(inner(point))) < 0.01);
    }
}

TEST_CASE("rounding is to nearest, halves up")
{
    const Affine half{.xx = q16(0.5), .yy = q16(0.5)};
    const auto raw = [&half](int value) { return half({Fixed::from_raw(value), {}}).x.raw(); };
    CHECK(raw(1) == 1);
    CHECK(raw(-1) == 0);
    CHECK(raw(-3) == -1);
}

TEST_CASE("growth is the mean of all directions that keeps areas")
{
    CHECK(Affine{.xx = q16(-3), .yy = q16(3)}.scale_factor() == q16(3));
    CHECK(Affine{.xx = q16(4), .yy = q16(9)}.scale_factor() == q16(6));
    CHECK(Affine{.xx = 0, .xy = q16(-2), .yx = q16(2), .yy = 0}.scale_factor() == q16(2));
    CHECK(Affine{.xx = q16(1), .xy = q16(1), .yx = q16(1), .yy = q16(1)}.scale_factor() == 0);
    const Affine max_factor{.xx = Affine::max_factor,
                            .xy = -Affine::max_factor,
                            .yx = Affine::max_factor,
                            .yy = Affine::max_factor};
    CHECK(std::abs(max_factor.scale_factor() / (std::sqrt(2.0) * Affine::max_factor) - 1) < 1e-6);
}

TEST_CASE("what would leave the ranges is held at their ends")
{
    const Affine steep{.xx = Affine::max_factor, .yy = -Affine::max_factor, .x0 = q16(4000), .y0 = 0};
    CHECK((steep * steep).xx == Affine::max_factor);
    CHECK((steep * Affine{.xx = -2 * Fixed::one}).xx == -Affine::max_factor);
    CHECK(steep(pixels(2000, 2000)) == pixels(16383, -16383));
    Affine deep = steep;
    for (int depth = 0; depth < 9; ++depth)
        deep = deep * Affine{.xx = Affine::max_factor,
                             .yy = Affine::max_factor,
                             .x0 = std::int64_t{65536} << 16,
                             .y0 = -(std::int64_t{65536} << 16)};
    CHECK(deep(pixels(0, 0)) == pixels(16383, 16383));
}

TEST_CASE("half a width grows with the lengths and has an end")
{
    CHECK(half_width(Fixed::pixels(5), Fixed::one) == pixels(2.5, 0).x);
    CHECK(half_width(Fixed::pixels(5), 3 * Fixed::one) == pixels(7.5, 0).x);
    CHECK(half_width(Fixed::from_raw(1), Fixed::one).raw() == 1); // rounded up
    CHECK(half_width(Fixed::pixels(4095), Affine::max_factor) == Fixed::pixels(4095));
}

}
