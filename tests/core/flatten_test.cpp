#include "core/flatten.hpp"

#include "tests/core/array_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

struct Vector {
    double x;
    double y;
};

Vector in_pixels(Point point) { return {point.x.raw() / 65536.0, point.y.raw() / 65536.0}; }

Segment random_cubic(std::mt19937& random)
{
    const auto coordinate = [&random] { return static_cast<double>(random() % 300); };
    const auto point = [&] {
        const double x = coordinate();
        return pixels(x, coordinate());
    };
    Segment cubic{.kind = Segment::Kind::cubic};
    for (Point* at : {&cubic.from, &cubic.c1, &cubic.c2, &cubic.to})
        *at = point();
    return cubic;
}

double bend(Point a, Point b, Point c)
{
    const auto [ax, ay] = in_pixels(a);
    const auto [bx, by] = in_pixels(b);
    const auto [cx, cy] = in_pixels(c);
    return std::hypot(ax - 2 * bx + cx, ay - 2 * by + cy);
}

/// How far the middle of each piece is from the curve's point at the same parameter: no less than the pieces
/// are from the curve.
double worst_distance(const Segment& cubic, std::uint32_t pieces)
{
    double worst = 0;
    std::uint32_t piece = 0;
    Vector from = in_pixels(cubic.from);
    flatten(cubic, pieces, [&](Point point) {
        const Vector to = in_pixels(point);
        const Vector exact = in_pixels(point_at(cubic, Share::ratio(2 * piece++ + 1, 2 * pieces)));
        worst = std::max(worst, std::hypot((from.x + to.x) / 2 - exact.x, (from.y + to.y) / 2 - exact.y));
        from = to;
    });
    return worst;
}

}

TEST_CASE("n pieces lie within 3 d / 4 n^2 of their curve")
{
    constexpr double rounding = 0.02; // shares of 1/65536 of curves of some hundred pixels
    std::mt19937 random{65};
    double closest = 0;
    for (int round = 0; round < 500; ++round) {
        const Segment cubic = random_cubic(random);
        const double d = std::max(bend(cubic.from, cubic.c1, cubic.c2), bend(cubic.c1, cubic.c2, cubic.to));
        for (const std::uint32_t pieces : {1U, 2U, 3U, 7U, 30U}) {
            const double bound = 3 * d / (4.0 * pieces * pieces);
            const double worst = worst_distance(cubic, pieces);
            CHECK(worst <= bound + rounding);
            closest = std::max(closest, worst / bound);
        }
    }
    CHECK(closest > 0.9); // the bound is not a guess far off
}

TEST_CASE("a curve can be flattened into 65535 pieces")
{
    std::mt19937 random{66};
    const Segment cubic = random_cubic(random);
    std::uint32_t pieces = 0;
    Point at;
    flatten(cubic, 65535, [&](Point to) {
        ++pieces;
        at = to;
    });
    CHECK(pieces == 65535);
    CHECK(at == cubic.to);
}

}
