#include "host/compiler/curve_pieces.hpp"

#include "core/flatten.hpp"
#include "host/compiler/model_reader.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

scene::Drawing one_curve(std::mt19937& random, int reach)
{
    const auto point = [&random, reach] {
        const auto coordinate = [&random, reach] {
            return static_cast<std::int16_t>(static_cast<int>(random() % static_cast<unsigned>(2 * reach)) -
                                             reach);
        };
        const std::int16_t x = coordinate();
        return scene::Point{x, coordinate()};
    };
    return {{{point(), {{.cubic = true, .c1 = point(), .c2 = point(), .to = point()}}}}};
}

Segment segment_of(const scene::Drawing& drawing)
{
    ModelReader reader{drawing};
    reader.next_stroke();
    return reader.next_segment();
}

double in_pixels(Fixed value) { return value.raw() / 65536.0; }

double distance_to_line(Point at, Point a, Point b)
{
    const double x = in_pixels(b.x - a.x);
    const double y = in_pixels(b.y - a.y);
    const double length = std::hypot(x, y);
    const Point from_a = at - a;
    if (length < 1 / 1024.0)
        return std::hypot(in_pixels(from_a.x), in_pixels(from_a.y));
    return std::abs(x * in_pixels(from_a.y) - y * in_pixels(from_a.x)) / length;
}

/// Half of them within both ends, as most laws are.
WayRange any_range(std::mt19937& random)
{
    if (random() % 2 == 0)
        return {};
    return {{-static_cast<std::int32_t>(random() % 98304)},
            {Way::one + static_cast<std::int32_t>(random() % 98304)}};
}

Way any_way(std::mt19937& random, WayRange range)
{
    const auto width = static_cast<std::uint32_t>(range.most.raw - range.least.raw) + 1;
    switch (random() % 4) {
    case 0:
        return range.least;
    case 1:
        return range.most;
    default:
        return {range.least.raw + static_cast<std::int32_t>(random() % width)};
    }
}

/// How far the middles of the curve's pieces are from the straight pieces.
double worst_distance(const Segment& curve, std::uint32_t pieces)
{
    double worst = 0;
    for (std::uint32_t i = 0; i < pieces; ++i)
        worst = std::max(worst, distance_to_line(point_at(curve, Share::ratio(2 * i + 1, 2 * pieces)),
                                                 point_at(curve, Share::ratio(i, pieces)),
                                                 point_at(curve, Share::ratio(i + 1, pieces))));
    return worst;
}

}

TEST_CASE("pieces keep within 1/32 px of their curve, anywhere on the way and for any laws")
{
    std::mt19937 random{81};
    double worst = 0;
    for (int round = 0; round < 400; ++round) {
        const int reach = 16 << random() % 11;
        const scene::Drawing a = one_curve(random, reach);
        const scene::Drawing b = one_curve(random, reach);
        const WayRange range_x = any_range(random);
        const WayRange range_y = any_range(random);
        const std::uint32_t pieces = curve_pieces(a, b, range_x, range_y);
        for (int moment = 0; moment < 6; ++moment) {
            const Way x = any_way(random, range_x);
            const Way y = any_way(random, range_y);
            worst = std::max(worst, worst_distance(tween(segment_of(a), segment_of(b), x, y), pieces));
        }
    }
    CHECK(worst <= 1 / 32.0 + 1e-4);
    CHECK(worst > 1 / 64.0); // and no finer than it takes
}

TEST_CASE("the way that swings furthest takes more pieces, and no more than it must")
{
    const scene::Drawing a{{{{0, 0}, {{.cubic = true, .c1 = {0, 160}, .c2 = {160, 160}, .to = {160, 0}}}}}};
    const scene::Drawing b{{{{0, 0}, {{.cubic = true, .c1 = {0, 1600}, .c2 = {160, 1600}, .to = {160, 0}}}}}};
    CHECK(curve_pieces(a, b, {}, {}) == 50);
    CHECK(curve_pieces(a, b, {}, {.most = {2 * Way::one}}) == 68);
    CHECK(curve_pieces(a, b, {.most = {2 * Way::one}}, {}) == 50); // nothing differs in x
    CHECK(curve_pieces(a, b, {}, {.least = {-Way::one}}) == 50);   // -8 times as high as a: less than b
    CHECK(curve_pieces(b, a, {}, {.least = {-Way::one}}) == 68);
}

TEST_CASE("lines need one piece")
{
    const scene::Drawing line{{{{0, 0}, {{.cubic = false, .c1 = {}, .c2 = {}, .to = {1600, 900}}}}}};
    CHECK(curve_pieces(line, line, {}, {.most = {2 * Way::one}}) == 1);
    CHECK(curve_pieces({}, {}, {}, {}) == 1);
}

}
