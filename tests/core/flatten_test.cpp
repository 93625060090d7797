#include "core/flatten.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
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

std::vector<Point> flattened(const Segment& segment, int pieces)
{
    std::vector<Point> points;
    flatten(segment, pieces, [&points](Point to) { points.push_back(to); });
    return points;
}

/// By Bernstein's polynomials in integers, n^3 times too large.
std::int64_t sum_at(const Segment& cubic, std::int64_t step, std::int64_t n, Fixed Point::*axis)
{
    const std::int64_t rest = n - step;
    return rest * rest * rest * (cubic.from.*axis).raw() + 3 * rest * rest * step * (cubic.c1.*axis).raw() +
           3 * rest * step * step * (cubic.c2.*axis).raw() + step * step * step * (cubic.to.*axis).raw();
}

std::int64_t floor_divided(std::int64_t dividend, std::int64_t divisor)
{
    return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
}

/// The point on the curve, rounded to nearest, halves up, moved by 5/64 of the second difference unless it is
/// the last.
std::int32_t exact(const Segment& cubic, std::int64_t step, std::int64_t n, Fixed Point::*axis)
{
    const auto sum = [&](std::int64_t at) { return sum_at(cubic, at, n, axis); };
    const std::int64_t cube = n * n * n;
    const auto point = static_cast<std::int32_t>(floor_divided(sum(step) + cube / 2, cube));
    if (step == n)
        return point;
    const auto bend =
        static_cast<std::int32_t>(floor_divided(sum(step + 1) - 2 * sum(step) + sum(step - 1), cube));
    return point - (bend >> 4) - (bend >> 6);
}

/// How far a point may be from the exact one, in raw units: the value, and two parts of its second
/// difference.
int most_off(int pieces) { return std::has_single_bit(static_cast<unsigned>(pieces)) ? 0 : 3; }

int random_pieces(std::mt19937& random)
{
    const int pieces = 1 + static_cast<int>(random() % 35);
    return pieces <= 32 ? pieces : 1 << (pieces - 27); // 64, 128, 256
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
double worst_distance(const Segment& cubic, int count)
{
    constexpr int samples = 16;
    const std::vector<Point> points = flattened(cubic, count);
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

TEST_CASE("a line is one piece, a curve as many as are asked for, the last point its own")
{
    std::mt19937 random{64};
    const Segment cubic = random_cubic(random, 300 * Fixed::one);
    CHECK(flattened({.from = pixels(0, 0), .to = pixels(5, 5)}, 3) == std::vector{pixels(5, 5)});
    for (int round = 0; round < 200; ++round) {
        const int pieces = random_pieces(random);
        CHECK(flattened(cubic, pieces).size() == static_cast<std::size_t>(pieces));
        CHECK(flattened(cubic, pieces).back() == cubic.to);
    }
}

TEST_CASE("every point is the exact one, or next to it, however small or large the curve")
{
    std::mt19937 random{61};
    int off = 0;
    for (int round = 0; round < 30'000; ++round) {
        const std::int32_t reach = Fixed::pixels(16383).raw() >> random() % 26;
        const Segment cubic = random_cubic(random, reach);
        const int pieces = random_pieces(random);
        std::int64_t step = 0;
        int worst = 0;
        for (const Point& point : flattened(cubic, pieces)) {
            ++step;
            worst = std::max({worst, std::abs(int(point.x.raw() - exact(cubic, step, pieces, &Point::x))),
                              std::abs(int(point.y.raw() - exact(cubic, step, pieces, &Point::y)))});
        }
        REQUIRE(worst <= most_off(pieces));
        off += worst > 1 ? 1 : 0;
    }
    CHECK(off < 30'000 / 100);
}

TEST_CASE("points at the ends of the range are flattened exactly")
{
    const auto far = [](int x, int y) { return Point{Fixed::pixels(16383 * x), Fixed::pixels(16383 * y)}; };
    const Segment cubic{Segment::Kind::cubic, far(-1, 1), far(1, -1), far(-1, -1), far(1, 1)};
    for (const int pieces : {1, 2, 3, 5, 8, 17, 31, 32, 64, 128, 256}) {
        std::int64_t step = 0;
        for (const Point& point : flattened(cubic, pieces)) {
            ++step;
            REQUIRE(std::abs(point.x.raw() - exact(cubic, step, pieces, &Point::x)) <= most_off(pieces));
            REQUIRE(std::abs(point.y.raw() - exact(cubic, step, pieces, &Point::y)) <= most_off(pieces));
        }
    }
}

TEST_CASE("32 bits are enough up to where the fast way ends, and both ways lead to the same places")
{
    std::mt19937 random{63};
    int fast = 0;
    for (int round = 0; round < 20'000; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(512).raw() >> random() % 16);
        const int pieces = 2 + static_cast<int>(random() % 63);
        if (!is_small(cubic, pieces) || (pieces > 32 && pieces != 64))
            continue;
        ++fast;
        std::vector<Point> wide;
        const auto add = [&wide](Point to) { wide.push_back(to); };
        flatten_in<std::uint64_t>(cubic, pieces, add);
        wide.push_back(cubic.to);
        const std::vector<Point> narrow = flattened(cubic, pieces);
        REQUIRE(narrow.size() == wide.size());
        int worst = 0;
        for (std::size_t i = 0; i < wide.size(); ++i)
            worst = std::max({worst, std::abs((narrow[i].x - wide[i].x).raw()),
                              std::abs((narrow[i].y - wide[i].y).raw())});
        REQUIRE(worst <= most_off(pieces));
    }
    CHECK(fast > 3'000);
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
        for (const Point& point : flattened(cubic, random_pieces(random))) {
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
        for (const int pieces : {1, 2, 3, 4, 6, 9, 16, 23, 32}) {
            const double bound = 3 * d / 4 / pieces / pieces;
            const double worst = worst_distance(cubic, pieces);
            CHECK(worst <= bound + 0.0001);
            closest = std::max(closest, worst / bound);
        }
    }
    CHECK(closest > 0.6); // the bound is not a guess far off
}

TEST_CASE("a curve is cut into enough pieces, and hardly more")
{
    constexpr double flat = 1 / 16.0;
    std::mt19937 random{66};
    for (int round = 0; round < 2'000; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(400).raw() >> random() % 12);
        const int pieces = pieces_for(cubic);
        CHECK(worst_distance(cubic, pieces) <= flat);
        const double d = std::max(bend(cubic.from, cubic.c1, cubic.c2), bend(cubic.c1, cubic.c2, cubic.to));
        const double most = std::sqrt(3 * d * 9 / 8 / 4 / flat); // |d| is computed up to 1/8 too long
        CHECK(pieces <= (pieces <= 32 ? most + 1.01 : 2 * most));
    }
    CHECK(pieces_for({.from = pixels(0, 0), .to = pixels(900, 5)}) == 1);
    CHECK(pieces_for({Segment::Kind::cubic, pixels(0, 0), pixels(1, 0), pixels(2, 0), pixels(3, 0)}) == 1);
}

TEST_CASE("the most curved cubics have as many pieces as may be")
{
    const auto far = [](int x, int y) { return Point{Fixed::pixels(16383 * x), Fixed::pixels(16383 * y)}; };
    CHECK(pieces_for({Segment::Kind::cubic, far(-1, 1), far(1, -1), far(-1, -1), far(1, 1)}) == most_pieces);
}

}
