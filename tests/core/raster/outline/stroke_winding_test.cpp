#include "core/math/flatten.hpp"
#include "core/raster/outline/stroke_outline.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/raster/outline/chain_lines.hpp"
#include "tests/core/raster/outline/pen_trace.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

/// Arcs may be `flatness` off, tips of slight bends 1/64 px, and corners and crossings half a step of the
/// grid in either direction.
constexpr double grid_step = 1.0 / raster::grid;
constexpr double tolerance = 1 / 24.0 + 1 / 64.0 + 1.5 * grid_step + 0.01;

void trace(raster::OutlineStore& store, const std::vector<Point>& points, const Pen& pen, bool is_closed)
{
    StrokeOutline outline{store, pen, 0};
    outline.begin(points.front());
    for (const Point& point : points)
        outline.line_to(point);
    outline.end(is_closed);
}

std::string text_of(const std::vector<Point>& points, const Pen& pen, bool is_closed)
{
    std::string text = std::string{"cap "} + std::to_string(static_cast<int>(pen.cap)) + " join " +
                       std::to_string(static_cast<int>(pen.join)) + " half width " +
                       std::to_string(pen.half_width.raw() / 65536.0) + (is_closed ? " closed" : " open");
    for (const Point& point : points)
        text.append(" ")
            .append(std::to_string(spot(point).x))
            .append(",")
            .append(std::to_string(spot(point).y));
    return text;
}

/// Inside wherever the pen has been, outside elsewhere, and nowhere wound the other way. Corners within rows
/// may be dropped, but not what crosses their borders.
void check_winding(std::mt19937& random, const std::vector<Point>& points, const Pen& pen, bool is_closed)
{
    OwnedOutlines outlines{{200, 200}};
    trace(outlines.store(), points, pen, is_closed);
    const std::vector<ChainLine> lines = lines_of(outlines.store());
    const PenTrace exact{points, pen, is_closed};
    std::uniform_real_distribution<double> coordinate{40, 160};
    std::uniform_int_distribution<int> border{40, 160};
    CAPTURE(text_of(points, pen, is_closed));
    for (int sample = 0; sample < 150; ++sample) {
        const Spot at{coordinate(random), static_cast<double>(border(random))};
        CAPTURE(at.x);
        CAPTURE(at.y);
        const int winding = winding_at(lines, at);
        CHECK(winding >= 0);
        if (exact.covers(at, -tolerance))
            CHECK(winding > 0);
        else if (!exact.covers(at, tolerance))
            CHECK(winding == 0);
    }
}

Pen random_pen(std::mt19937& random, double widest)
{
    std::uniform_real_distribution<double> width{0.1, widest};
    return {.half_width = pixels(width(random), 0).x,
            .cap = static_cast<Cap>(random() % 3),
            .join = static_cast<Join>(random() % 3),
            .miter_limit = 8 + static_cast<int>(random() % 100)};
}

std::vector<Point> random_points(std::mt19937& random, double reach)
{
    std::uniform_real_distribution<double> coordinate{100 - reach, 100 + reach};
    std::vector<Point> points(2 + random() % 5);
    for (Point& point : points) {
        const double x = coordinate(random);
        point = pixels(x, coordinate(random));
    }
    return points;
}

std::vector<Point> curve(std::mt19937& random, double reach)
{
    const std::vector<Point> ends = random_points(random, reach);
    std::uniform_real_distribution<double> coordinate{100 - reach, 100 + reach};
    const auto control = [&] {
        const double x = coordinate(random);
        return pixels(x, coordinate(random));
    };
    std::vector<Point> points{ends[0]};
    Segment cubic{Segment::Kind::cubic, ends[0], control(), control(), ends[1]};
    if (random() % 4 == 0) // a cusp: the curve turns back at its middle
        cubic.c1 = ends[1] + ends[1] - ends[0], cubic.c2 = ends[0] + ends[0] - ends[1];
    flatten(cubic, pieces_for(cubic), [&points](Point to) { points.push_back(to); });
    return points;
}

}

TEST_CASE("strokes of random lines wind around what the pen covers, with every cap and join")
{
    std::mt19937 random{51};
    for (int round = 0; round < rounds(1500); ++round) {
        const Pen pen = random_pen(random, round % 2 == 0 ? 4 : 30);
        const auto points = random_points(random, round % 3 == 0 ? 10 : 45);
        check_winding(random, points, pen, points.size() > 2 && random() % 2 == 0);
    }
}

TEST_CASE("strokes of random curves do so too, also where they turn back, or the pen is wide")
{
    std::mt19937 random{52};
    for (int round = 0; round < rounds(1500); ++round) {
        const Pen pen = random_pen(random, round % 2 == 0 ? 4 : 30);
        check_winding(random, curve(random, round % 3 == 0 ? 8 : 45), pen, random() % 4 == 0);
    }
}

}
