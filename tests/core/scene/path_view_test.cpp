#include "core/scene/track_view.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/spot.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr double whole = 1 << 24;

std::int32_t share_of(double share) { return static_cast<std::int32_t>(std::lround(share * whole)); }

/// A path with what it borrows.
class RawPath {
public:
    RawPath(const scene::Stroke& stroke, const std::vector<std::uint32_t>& lengths)
        : drawing_{packed({{stroke}})}, bytes_{path_bytes(false, 0, lengths)}
    {
    }

    PathPlace at(double share) const
    {
        ByteReader reader{bytes_};
        return place_on(PathView::take(reader), drawing_at(drawing_, 0), share_of(share));
    }

private:
    Bytes drawing_;
    Bytes bytes_;
};

scene::Segment curve_to(scene::Point c1, scene::Point c2, scene::Point to)
{
    return {.cubic = true, .c1 = c1, .c2 = c2, .to = to};
}

Spot in_pixels(scene::Point point) { return {point.x / 16.0, point.y / 16.0}; }

/// A curve by its formula.
struct ExactCurve {
    Spot from;
    Spot c1;
    Spot c2;
    Spot to;

    Spot at(double t) const
    {
        const double s = 1 - t;
        return s * s * s * from + 3 * s * s * t * c1 + 3 * s * t * t * c2 + t * t * t * to;
    }

    Spot slope(double t) const
    {
        const double s = 1 - t;
        return s * s * (c1 - from) + 2 * s * t * (c2 - c1) + t * t * (to - c2);
    }
};

/// In 1/65536 turn, within half a turn either way.
double turn_between(BinaryAngle is, Spot direction)
{
    const double exact = std::atan2(direction.y, direction.x) / (2 * std::numbers::pi) * 65536;
    return std::remainder(is.raw - exact, 65536.0);
}

/// 30 px to the right, 40 px down, 50 px back to the beginning.
const RawPath triangle_path{polyline_of({{160, 160}, {640, 160}, {640, 800}, {160, 160}}), {480, 640, 800}};

}

TEST_CASE("a path is read with its bits, its drawing and its lengths, and what follows is left")
{
    const Bytes two = joined({path_bytes(true, 300, {5, 1000}), bytes({99})});
    ByteReader reader{two};
    const PathView path = PathView::take(reader);
    CHECK(path.is_known);
    CHECK(path.turns);
    CHECK(path.drawing == 300);
    ByteReader lengths = path.lengths;
    CHECK(lengths.varint() == 5);
    CHECK(lengths.varint() == 1000);
    CHECK(lengths.left() == 0);
    CHECK(reader.left() == 1);
    const Bytes unknown = bytes({3, 2, 0, 1});
    ByteReader other{unknown};
    CHECK_FALSE(PathView::take(other).is_known);
}

TEST_CASE("lines are followed at the same speed all along")
{
    CHECK(triangle_path.at(0).at == pixels(10, 10));
    CHECK(triangle_path.at(0.125).at == pixels(25, 10));
    CHECK(triangle_path.at(0.25).at == pixels(40, 10));
    CHECK(triangle_path.at(0.5).at == pixels(40, 40));
    double worst = 0;
    for (int step = 0; step <= 1200; ++step) {
        const double way = step / 10.0;
        const Spot exact = way < 30   ? Spot{10 + way, 10}
                           : way < 70 ? Spot{40, 10 + way - 30}
                                      : Spot{40 - 0.6 * (way - 70), 50 - 0.8 * (way - 70)};
        worst = std::max(worst, apart(triangle_path.at(way / 120).at, exact));
    }
    CHECK(worst < 0.01);
}

TEST_CASE("the end of a path is its last point, and what lies outside is held at the ends")
{
    const RawPath open{polyline_of({{0, 0}, {160, 0}, {160, 16}}), {160, 16}};
    CHECK(open.at(1).at == pixels(10, 1));
    CHECK(open.at(1.5).at == pixels(10, 1));
    CHECK(open.at(100).at == pixels(10, 1));
    CHECK(open.at(-0.25).at == pixels(0, 0));
    CHECK(open.at(-100).at == pixels(0, 0));
    CHECK(open.at(2).direction.raw == BinaryAngle::quarter_turn);
    CHECK(open.at(-2).direction.raw == 0);
}

TEST_CASE("the direction is that of the line, of the earlier one where two meet")
{
    CHECK(triangle_path.at(0.1).direction.raw == 0);
    CHECK(triangle_path.at(0.25).direction.raw == 0);
    CHECK(triangle_path.at(0.3).direction.raw == BinaryAngle::quarter_turn);
    CHECK(std::abs(turn_between(triangle_path.at(0.8).direction, {-0.6, -0.8})) <= 1);
}

TEST_CASE("a curve is followed by its parameter, within 3/65536 px, in its direction")
{
    std::mt19937 random{97};
    double worst = 0;
    double max_turned = 0;
    for (int round = 0; round < 3000; ++round) {
        const scene::Point from = random_point(random);
        const scene::Point c1 = random_point(random);
        const scene::Point c2 = random_point(random);
        const scene::Point to = random_point(random);
        const RawPath path{{from, {curve_to(c1, c2, to)}}, {4096}};
        const ExactCurve exact{in_pixels(from), in_pixels(c1), in_pixels(c2), in_pixels(to)};
        const double share = static_cast<double>(random() % 65537) / 65536;
        worst = std::max(worst, apart(path.at(share).at, exact.at(share)));
        const Spot slope = exact.slope(share);
        if (std::hypot(slope.x, slope.y) > 8)
            max_turned = std::max(max_turned, std::abs(turn_between(path.at(share).direction, slope)));
    }
    CHECK(worst * 65536 < 3);
    CHECK(max_turned < 2);
}

TEST_CASE("at the ends of a curve the direction is that of the next control point that lies elsewhere")
{
    const auto directions = [](scene::Point c1, scene::Point c2, scene::Point to) {
        const RawPath path{{{0, 0}, {curve_to(c1, c2, to)}}, {1000}};
        return std::array{path.at(0).direction.raw, path.at(1).direction.raw};
    };
    constexpr std::uint16_t right = 0;
    constexpr std::uint16_t down = BinaryAngle::quarter_turn;
    constexpr std::uint16_t left = BinaryAngle::half_turn;
    using Both = std::array<std::uint16_t, 2>;
    CHECK(directions({0, 800}, {1600, 800}, {800, 800}) == Both{down, left});
    CHECK(directions({0, 0}, {0, 800}, {800, 800}) == Both{down, right});
    CHECK(directions({0, 800}, {800, 800}, {800, 800}) == Both{down, right});
    CHECK(directions({0, 0}, {800, 0}, {800, 0}) == Both{right, right});
    CHECK(directions({0, 0}, {0, 0}, {0, 800}) == Both{down, down});
    CHECK(directions({0, 800}, {0, 800}, {0, 800}) == Both{down, down});
}

TEST_CASE("just behind the end of a degenerate curve the direction is much the same")
{
    const RawPath path{{{0, 0}, {curve_to({0, 0}, {0, 800}, {800, 800})}}, {1000}};
    for (const double share : {0.0005, 0.002, 0.01})
        CHECK(std::abs(turn_between(path.at(share).direction, {1.5 * share, 1})) < 65536.0 / 360 * 2);
}

TEST_CASE("lines and curves have the shares of their lengths, whatever they measure")
{
    const RawPath path{{{0, 0},
                        {{.cubic = false, .c1 = {}, .c2 = {}, .to = {160, 0}},
                         curve_to({320, 0}, {480, 160}, {480, 320}),
                         {.cubic = false, .c1 = {}, .c2 = {}, .to = {480, 640}}}},
                       {1, 2, 1}};
    CHECK(path.at(0.125).at == pixels(5, 0));
    CHECK(path.at(0.25).at == pixels(10, 0));
    const ExactCurve curve{{10, 0}, {20, 0}, {30, 10}, {30, 20}};
    CHECK(apart(path.at(0.5).at, curve.at(0.5)) < 0.001);
    CHECK(path.at(0.75).at == pixels(30, 20));
    CHECK(path.at(0.875).at == pixels(30, 30));
}

TEST_CASE("the longest path does not wrap")
{
    const RawPath path{polyline_of({{0, 0}, {16, 0}, {32, 0}}), {8'388'606, 1}};
    CHECK(apart(path.at(0.5).at, {0.5, 0}) < 0.001);
    CHECK(path.at(1).at == pixels(2, 0));
}

}
