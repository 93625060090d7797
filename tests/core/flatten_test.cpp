#include "core/flatten.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

/// Points up to `reach` raw units away from the first one, and that one anywhere they leave room for.
Segment random_cubic(std::mt19937& random, std::int32_t reach)
{
    const auto within = [&random](std::int32_t limit) {
        return std::uniform_int_distribution<std::int32_t>{-limit, limit}(random);
    };
    const auto point = [&within](std::int32_t limit) {
        const Fixed x = Fixed::from_raw(within(limit));
        return Point{x, Fixed::from_raw(within(limit))};
    };
    const Point from = point(Fixed::pixels(16383).raw() - reach);
    return {Segment::Kind::cubic, from, from + point(reach), from + point(reach), from + point(reach)};
}

std::vector<Point> flattened(const Segment& segment, int halvings)
{
    std::vector<Point> points;
    flatten(segment, halvings, [&points](Point to) { points.push_back(to); });
    return points;
}

/// By Bernstein's polynomials in integers, n^3 times too large.
std::int64_t sum_at(const Segment& cubic, std::int64_t step, int halvings, Fixed Point::*axis)
{
    const std::int64_t n = std::int64_t{1} << halvings;
    const std::int64_t rest = n - step;
    return rest * rest * rest * (cubic.from.*axis).raw() + 3 * rest * rest * step * (cubic.c1.*axis).raw() +
           3 * rest * step * step * (cubic.c2.*axis).raw() + step * step * step * (cubic.to.*axis).raw();
}

/// The point on the curve, rounded to nearest, halves up, moved by 5/64 of the second difference unless it is
/// the last.
std::int32_t exact(const Segment& cubic, std::int64_t step, int halvings, Fixed Point::*axis)
{
    const auto sum = [&](std::int64_t at) { return sum_at(cubic, at, halvings, axis); };
    const std::int64_t n = std::int64_t{1} << halvings;
    const auto point = static_cast<std::int32_t>((sum(step) + n * n * n / 2) >> 3 * halvings);
    if (step == n)
        return point;
    const auto bend =
        static_cast<std::int32_t>((sum(step + 1) - 2 * sum(step) + sum(step - 1)) >> 3 * halvings);
    return point - (bend >> 4) - (bend >> 6);
}

Spot at(const Segment& cubic, double t)
{
    const double s = 1 - t;
    return s * s * s * spot(cubic.from) + 3 * s * s * t * spot(cubic.c1) + 3 * s * t * t * spot(cubic.c2) +
           t * t * t * spot(cubic.to);
}

double distance(Spot from, Spot to, Spot point)
{
    const Spot along = to - from;
    const Spot away = point - from;
    const double square = along.x * along.x + along.y * along.y;
    const double t = square == 0 ? 0 : std::clamp((away.x * along.x + away.y * along.y) / square, 0.0, 1.0);
    return std::hypot(away.x - t * along.x, away.y - t * along.y);
}

/// How far the pieces are from the curve between their ends.
double worst_distance(const Segment& cubic, int halvings)
{
    constexpr int samples = 16;
    const std::vector<Point> points = flattened(cubic, halvings);
    const auto pieces = static_cast<double>(points.size());
    double worst = 0;
    Spot from = spot(cubic.from);
    for (std::size_t piece = 0; piece < points.size(); ++piece) {
        const Spot to = spot(points[piece]);
        for (int i = 1; i < samples; ++i)
            worst = std::max(worst,
                             distance(from, to, at(cubic, (double(piece) + double(i) / samples) / pieces)));
        from = to;
    }
    return worst;
}

double bend(Point a, Point b, Point c)
{
    const Spot twice = spot(a) - 2 * spot(b) + spot(c);
    return std::hypot(twice.x, twice.y);
}

}

TEST_CASE("a line is one piece, a curve two to the power of its halvings, the last point its own")
{
    std::mt19937 random{64};
    const Segment cubic = random_cubic(random, 300 * Fixed::one);
    CHECK(flattened({.from = pixels(0, 0), .to = pixels(5, 5)}, 3) == std::vector{pixels(5, 5)});
    for (int halvings = 0; halvings <= most_halvings; ++halvings) {
        CHECK(flattened(cubic, halvings).size() == std::size_t{1} << halvings);
        CHECK(flattened(cubic, halvings).back() == cubic.to);
    }
}

TEST_CASE("every point is the exact one, however small or large the curve")
{
    std::mt19937 random{61};
    for (int round = 0; round < 30'000; ++round) {
        const std::int32_t reach = Fixed::pixels(16383).raw() >> random() % 26;
        const Segment cubic = random_cubic(random, reach);
        const int halvings = static_cast<int>(random() % (most_halvings + 1));
        std::int64_t step = 0;
        bool all = true;
        for (const Point& point : flattened(cubic, halvings)) {
            ++step;
            all = all && point.x.raw() == exact(cubic, step, halvings, &Point::x) &&
                  point.y.raw() == exact(cubic, step, halvings, &Point::y);
        }
        REQUIRE(all);
    }
}

TEST_CASE("points at the ends of the range are flattened exactly")
{
    const auto far = [](int x, int y) { return Point{Fixed::pixels(16383 * x), Fixed::pixels(16383 * y)}; };
    const Segment cubic{Segment::Kind::cubic, far(-1, 1), far(1, -1), far(-1, -1), far(1, 1)};
    for (int halvings = 0; halvings <= most_halvings; ++halvings) {
        std::int64_t step = 0;
        for (const Point& point : flattened(cubic, halvings)) {
            ++step;
            REQUIRE(point.x.raw() == exact(cubic, step, halvings, &Point::x));
            REQUIRE(point.y.raw() == exact(cubic, step, halvings, &Point::y));
        }
    }
}

TEST_CASE("32 bits are enough up to where the fast way ends, and both ways give the same bits")
{
    std::mt19937 random{63};
    int fast = 0;
    for (int round = 0; round < 20'000; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(512).raw() >> random() % 16);
        const int halvings = 1 + static_cast<int>(random() % 6);
        if (!is_small(cubic, halvings))
            continue;
        ++fast;
        std::vector<Point> wide;
        const auto add = [&wide](Point to) { wide.push_back(to); };
        flatten_in<std::uint64_t>(cubic, halvings, add);
        wide.push_back(cubic.to);
        REQUIRE(flattened(cubic, halvings) == wide);
    }
    CHECK(fast > 5'000);
}

TEST_CASE("pieces hardly turn back more often than a cubic can: in y they run in three stretches")
{
    std::mt19937 random{62};
    int most_stretches = 0;
    int too_many = 0;
    for (int round = 0; round < 20'000; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(200).raw() >> random() % 24);
        int stretches = 0;
        int sense = 0;
        Fixed last = cubic.from.y;
        for (const Point& point : flattened(cubic, static_cast<int>(random() % 9))) {
            const int way = point.y > last ? 1 : point.y < last ? -1 : 0;
            if (way != 0 && way != sense) {
                ++stretches;
                sense = way;
            }
            last = point.y;
        }
        most_stretches = std::max(most_stretches, stretches);
        too_many += stretches > 3 ? 1 : 0;
    }
    CHECK(most_stretches <= 5);
    CHECK(too_many < 20'000 / 100);
}

TEST_CASE("n pieces lie within 3 d / 4 n^2 of their curve, and mostly nearer")
{
    std::mt19937 random{65};
    double closest = 0;
    for (int round = 0; round < 500; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(150).raw());
        const double d = std::max(bend(cubic.from, cubic.c1, cubic.c2), bend(cubic.c1, cubic.c2, cubic.to));
        for (int halvings = 0; halvings <= 5; ++halvings) {
            const double bound = 3 * d / std::pow(4.0, halvings + 1);
            const double worst = worst_distance(cubic, halvings);
            CHECK(worst <= bound + 0.0001);
            closest = std::max(closest, worst / bound);
        }
    }
    CHECK(closest > 0.6); // the bound is not a guess far off
}

TEST_CASE("a curve is halved until its pieces are flat, and hardly more often")
{
    constexpr double flat = 1 / 16.0;
    std::mt19937 random{66};
    int too_often = 0;
    for (int round = 0; round < 2'000; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(400).raw() >> random() % 12);
        const int halvings = halvings_for(cubic);
        CHECK(worst_distance(cubic, halvings) <= flat);
        const double d = std::max(bend(cubic.from, cubic.c1, cubic.c2), bend(cubic.c1, cubic.c2, cubic.to));
        too_often += halvings > 0 && 3 * d / std::pow(4.0, halvings) <= flat ? 1 : 0;
    }
    CHECK(too_often < 2'000 / 10); // |d| is computed up to 1/8 too long
    CHECK(halvings_for({.from = pixels(0, 0), .to = pixels(900, 5)}) == 0);
    CHECK(halvings_for({Segment::Kind::cubic, pixels(0, 0), pixels(1, 0), pixels(2, 0), pixels(3, 0)}) == 0);
}

TEST_CASE("the most curved cubics are halved as often as may be")
{
    const auto far = [](int x, int y) { return Point{Fixed::pixels(16383 * x), Fixed::pixels(16383 * y)}; };
    CHECK(halvings_for({Segment::Kind::cubic, far(-1, 1), far(1, -1), far(-1, -1), far(1, 1)}) ==
          most_halvings);
}

}
