#include "core/math/flatten.hpp"

#include "tests/core/array_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

Segment random_cubic(std::mt19937& random)
{
    const auto point = [&random] {
        const auto coordinate = [&random] {
            return Fixed::sixteenths(static_cast<std::int32_t>(random() % 65536) - 32768);
        };
        const Fixed x = coordinate();
        return Point{x, coordinate()};
    };
    return {Segment::Kind::cubic, point(), point(), point(), point()};
}

double exact(const Segment& cubic, double t, Fixed Point::*axis)
{
    const double s = 1 - t;
    return s * s * s * (cubic.from.*axis).raw() + 3 * s * s * t * (cubic.c1.*axis).raw() +
           3 * s * t * t * (cubic.c2.*axis).raw() + t * t * t * (cubic.to.*axis).raw();
}

}

TEST_CASE("a point of a curve is within two units of the exact one, at full range")
{
    std::mt19937 random{61};
    double worst = 0;
    for (int round = 0; round < 20'000; ++round) {
        const Segment cubic = random_cubic(random);
        const Fraction share{static_cast<std::uint32_t>(random() % (Fraction::one + 1))};
        const Point point = point_at(cubic, share);
        worst = std::max({worst, std::abs(point.x.raw() - exact(cubic, share.raw / 65536.0, &Point::x)),
                          std::abs(point.y.raw() - exact(cubic, share.raw / 65536.0, &Point::y))});
    }
    CHECK(worst <= 2);
}

TEST_CASE("a stretch of a curve is that part of the curve")
{
    std::mt19937 random{62};
    double worst = 0;
    for (int round = 0; round < 5'000; ++round) {
        const Segment cubic = random_cubic(random);
        const auto begin = static_cast<std::uint32_t>(random() % Fraction::one);
        const auto end = begin + static_cast<std::uint32_t>(random() % (Fraction::one - begin)) + 1;
        const Segment part = subsegment(cubic, {begin}, {end});
        const double inner = static_cast<double>(random() % 65537) / 65536;
        const double outer = (begin + inner * (end - begin)) / 65536;
        worst = std::max(worst, std::abs(exact(part, inner, &Point::x) - exact(cubic, outer, &Point::x)));
    }
    CHECK(worst <= 4);
}

TEST_CASE("stretches that meet share the very point, and the whole has its own ends")
{
    std::mt19937 random{63};
    for (int round = 0; round < 2'000; ++round) {
        const Segment cubic = random_cubic(random);
        const Fraction middle{static_cast<std::uint32_t>(random() % 65536)};
        CHECK(subsegment(cubic, {0}, middle).to == subsegment(cubic, middle, {Fraction::one}).from);
        CHECK(subsegment(cubic, {0}, {Fraction::one}) == cubic);
    }
}

TEST_CASE("x and y have ways of their own, which may lead beyond either end")
{
    const Segment a{.from = pixels(0, 0), .to = pixels(4, 0)};
    const Segment b{.from = pixels(8, 8), .to = pixels(12, 8)};
    const Segment live = tween(a, b, {Progress::one / 2}, {Progress::one / 4});
    CHECK(live.from == pixels(4, 2));
    CHECK(live.to == pixels(8, 2));
    CHECK(tween(a, b, {-Progress::one / 2}, {2 * Progress::one}).from == pixels(-4, 16));
}

}
