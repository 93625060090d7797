#include "core/math/flatten.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/spot.hpp"
#include "tests/rounds.hpp"

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

std::vector<Point> flattened(const Segment& segment, int pieces)
{
    std::vector<Point> points;
    flatten(segment, pieces, [&points](Point to) { points.push_back(to); });
    return points;
}

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

/// How far the points of `pieces` pieces are from where they belong: beside the curve, or, where a curve of
/// many pieces is cut, on it.
double worst_from_formula(const Segment& cubic, int pieces)
{
    const double h = 1.0 / pieces;
    double worst = 0;
    int step = 0;
    for (const Point& point : flattened(cubic, pieces)) {
        const double t = ++step * h;
        const Spot on_curve = at(cubic, t);
        const bool is_beside = step != pieces && step % max_steps != 0;
        const Spot bend = at(cubic, t + h) - 2 * on_curve + at(cubic, t - h);
        const Spot off = spot(point) - (is_beside ? on_curve - 1 / 12.0 * bend : on_curve);
        worst = std::max(worst, std::hypot(off.x, off.y));
    }
    return worst;
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

TEST_CASE("points lie beside the curve by a twelfth of their second difference, within 1/64 px")
{
    std::mt19937 random{61};
    for (int round = 0; round < rounds(30'000); ++round) {
        const std::int32_t reach = Fixed::pixels(1300).raw() >> random() % 22;
        const Segment cubic = random_cubic(random, reach);
        const int needed = pieces_for(cubic);
        const int pieces =
            needed < max_steps ? std::clamp(needed + static_cast<int>(random() % 3), 2, max_steps) : needed;
        const double off = worst_from_formula(cubic, pieces);
        REQUIRE(off <= std::max(1.0, reach / 65536.0 / 256) / 64);
    }
}

TEST_CASE("points are held in 32 bits at the ends of the range, where pieces are far too few")
{
    const auto far = [](int x, int y) { return Point{Fixed::pixels(16383 * x), Fixed::pixels(16383 * y)}; };
    const Segment cubic{Segment::Kind::cubic, far(-1, 1), far(1, -1), far(-1, -1), far(1, 1)};
    const Segment pinned{Segment::Kind::cubic, far(-1, 1), far(1, -1), far(1, -1), far(1, -1)};
    for (int pieces = 2; pieces <= max_steps; ++pieces)
        for (const Segment& segment : {cubic, pinned})
            CHECK(worst_from_formula(segment, pieces) <= 2048.0 / pieces / pieces + 48);
}

TEST_CASE("pieces hardly turn back more often than a cubic can: in y they run in three stretches")
{
    std::mt19937 random{62};
    int max_stretches = 0;
    int too_many = 0;
    for (int round = 0; round < 20'000; ++round) {
        const Segment cubic = random_cubic(random, Fixed::pixels(200).raw() >> random() % 24);
        int stretches = 0;
        int sense = 0;
        Fixed last = cubic.from.y;
        for (const Point& point : flattened(cubic, 1 + static_cast<int>(random() % max_steps))) {
            const int way = point.y > last ? 1 : point.y < last ? -1 : 0;
            if (way != 0 && way != sense) {
                ++stretches;
                sense = way;
            }
            last = point.y;
        }
        max_stretches = std::max(max_stretches, stretches);
        too_many += stretches > 3 ? 1 : 0;
    }
    CHECK(max_stretches <= 5);
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
        const double max = std::sqrt(3 * d * 9 / 8 / 4 / flat); // |d| is computed up to 1/8 too long
        CHECK(pieces <= (pieces <= 32 ? max + 1.01 : 2 * max));
    }
    CHECK(pieces_for({.from = pixels(0, 0), .to = pixels(900, 5)}) == 1);
    CHECK(pieces_for({Segment::Kind::cubic, pixels(0, 0), pixels(1, 0), pixels(2, 0), pixels(3, 0)}) == 1);
}

TEST_CASE("the most curved cubics have as many pieces as may be")
{
    const auto far = [](int x, int y) { return Point{Fixed::pixels(16383 * x), Fixed::pixels(16383 * y)}; };
    CHECK(pieces_for({Segment::Kind::cubic, far(-1, 1), far(1, -1), far(-1, -1), far(1, 1)}) == max_pieces);
}

}
