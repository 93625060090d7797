#include "core/raster/outline/stroke_outline.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/raster/coverage_picture.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

CoveragePicture stroked(const std::vector<Point>& points, const Pen& pen, bool is_closed = false)
{
    CoveragePicture picture{24, 24};
    StrokeOutline outline{picture.store(), pen, 0};
    outline.begin(points.front());
    for (const Point& point : points)
        outline.line_to(point);
    outline.end(is_closed);
    picture.draw();
    return picture;
}

constexpr Fixed half_width(double width) { return Fixed::from_raw(static_cast<std::int32_t>(width * 32768)); }

double total(const CoveragePicture& picture)
{
    double sum = 0;
    for (const int level : picture.levels())
        sum += level;
    return sum / raster::full_coverage;
}

double distance(double x, double y, Point a, Point b)
{
    const double ax = a.x.raw() / 65536.0, ay = a.y.raw() / 65536.0;
    const double dx = b.x.raw() / 65536.0 - ax, dy = b.y.raw() / 65536.0 - ay;
    const double square = dx * dx + dy * dy;
    const double t = square == 0 ? 0 : std::clamp(((x - ax) * dx + (y - ay) * dy) / square, 0.0, 1.0);
    return std::hypot(x - ax - t * dx, y - ay - t * dy);
}

double level_by_distance(const std::vector<Point>& points, double radius, int x, int y)
{
    constexpr int samples = 24;
    int inside = 0;
    for (int i = 0; i < samples * samples; ++i) {
        const int column = i / samples;
        const int row = i % samples;
        double nearest = 1e9;
        for (std::size_t k = 1; k < points.size(); ++k)
            nearest = std::min(nearest, distance(x + (column + 0.5) / samples, y + (row + 0.5) / samples,
                                                 points[k - 1], points[k]));
        inside += nearest <= radius;
    }
    return inside * double{raster::full_coverage} / (samples * samples);
}

}

TEST_CASE("a butt-capped line covers exactly its length and width")
{
    const auto picture = stroked({pixels(4, 10), pixels(14, 10)}, {.half_width = half_width(4)});
    CHECK(total(picture) == 40);
    CHECK(picture.at(4, 8) == raster::full_coverage);
    CHECK(picture.at(3, 9) == 0);
    CHECK(picture.at(13, 11) == raster::full_coverage);
    CHECK(picture.at(14, 10) == 0);
    CHECK(picture.at(8, 12) == 0);
}

TEST_CASE("two pieces that meet at the seam of a closed stroke cover what it does")
{
    const std::vector corners{pixels(5, 5), pixels(18, 7), pixels(16, 18), pixels(7, 15)};
    for (const Join join : {Join::miter, Join::round, Join::bevel}) {
        CAPTURE(join);
        const Pen pen{.half_width = half_width(5), .join = join};
        CoveragePicture picture{24, 24};
        StrokeOutline outline{picture.store(), pen, 0};
        outline.begin(corners[0]);
        outline.line_to(corners[1]);
        outline.line_to(corners[2]);
        outline.end_after_seam();
        outline.begin(corners[2]);
        outline.line_to(corners[3]);
        outline.line_to(corners[0]);
        outline.end_at_seam();
        picture.draw();
        const auto closed = stroked(corners, pen, true);
        for (int y = 0; y < 13; ++y) // below, the other corner has no join
            for (int x = 0; x < 24; ++x)
                CHECK(picture.at(x, y) == closed.at(x, y));
    }
}

TEST_CASE("square caps add half a width at both ends")
{
    const auto picture =
        stroked({pixels(6, 10), pixels(14, 10)}, {.half_width = half_width(4), .cap = Cap::square});
    CHECK(total(picture) == 48);
    CHECK(picture.at(4, 8) == raster::full_coverage);
    CHECK(picture.at(15, 11) == raster::full_coverage);
}

TEST_CASE("a stroke without length is a disc, a square or nothing, as its cap says")
{
    const std::vector<Point> dot{pixels(12, 12)};
    const auto with_cap = [&dot](Cap cap) {
        return total(stroked(dot, {.half_width = half_width(8), .cap = cap}));
    };
    CHECK(with_cap(Cap::round) == doctest::Approx(50.2).epsilon(0.015));
    CHECK(with_cap(Cap::square) == doctest::Approx(64));
    CHECK(with_cap(Cap::butt) == 0);
}

TEST_CASE("joins of a right angle: miter to the corner, bevel across it, round between them")
{
    const std::vector<Point> corner{pixels(4, 20), pixels(4, 4), pixels(20, 4)};
    const auto with_join = [&corner](Join join) {
        return total(stroked(corner, {.half_width = half_width(4), .join = join}));
    };
    CHECK(with_join(Join::miter) == doctest::Approx(16 * 4 * 2 + 0).epsilon(0.001));
    CHECK(with_join(Join::bevel) == doctest::Approx(16 * 4 * 2 - 2).epsilon(0.001));
    CHECK(with_join(Join::round) == doctest::Approx(16 * 4 * 2 - 4 + 3.1416).epsilon(0.001));
}

TEST_CASE("a miter longer than four widths becomes a bevel")
{
    const auto reach = [](double height) {
        const auto picture = stroked({pixels(0, 12 - height), pixels(12, 12), pixels(0, 12 + height)},
                                     {.half_width = half_width(2)});
        int x = 23;
        while (picture.at(x, 11) + picture.at(x, 12) == 0)
            --x;
        return x;
    };
    CHECK(reach(4) >= 14);  // half angle 18.4 degrees: the miter is 3.2 half widths long
    CHECK(reach(2.5) < 13); // 11.8 degrees: 4.9
}

TEST_CASE("a miter's limit is the pen's own")
{
    const std::vector<Point> corner{pixels(4, 20), pixels(4, 4), pixels(20, 4)}; // 1.414 half widths
    const auto area = [&corner](int limit) {
        return total(stroked(corner, {.half_width = half_width(4), .miter_limit = limit}));
    };
    CHECK(area(12) == area(255));
    CHECK(area(12) > area(11) + 1.9);
    CHECK(area(11) == area(8));
}

TEST_CASE("the tip of the longest miter of the widest pen stays within what Fixed holds")
{
    CoveragePicture picture{24, 24};
    StrokeOutline outline{picture.store(), {.half_width = Fixed::pixels(4095), .miter_limit = 255}, 0};
    outline.begin(pixels(0, -1000));
    outline.line_to(pixels(16383, 0));
    outline.line_to(pixels(0, 1000));
    outline.end(false);
    picture.draw();
    CHECK(picture.at(12, 12) == raster::full_coverage);
}

TEST_CASE("a closed stroke is joined where it began")
{
    const std::vector<Point> square{pixels(4, 4), pixels(20, 4), pixels(20, 20), pixels(4, 20), pixels(4, 4)};
    const Pen pen{.half_width = half_width(2)};
    CHECK(stroked(square, pen, true).at(3, 3) == raster::full_coverage);
    CHECK(stroked(square, pen, false).at(3, 3) == 0);
    CHECK(total(stroked(square, pen, true)) == doctest::Approx(18 * 18 - 14 * 14));
}

TEST_CASE("a stroke that crosses itself, or turns back, is as dark as one that does not")
{
    const auto there =
        stroked({pixels(4, 10.3), pixels(20, 10.3)}, {.half_width = half_width(3), .cap = Cap::round});
    const auto and_back = stroked({pixels(4, 10.3), pixels(20, 10.3), pixels(4, 10.3)},
                                  {.half_width = half_width(3), .cap = Cap::round, .join = Join::round});
    int worst = 0;
    for (std::size_t i = 0; i < there.levels().size(); ++i)
        worst = std::max(worst, std::abs(there.levels()[i] - and_back.levels()[i]));
    CHECK(worst <= 3);
}

TEST_CASE("points closer than 1/256 px are passed over: they do not turn a wide pen")
{
    const Pen pen{.half_width = half_width(8)};
    const auto with_noise =
        stroked({pixels(2, 12), pixels(12, 12), pixels(12 - 1 / 300.0, 12 + 1 / 300.0), pixels(22, 12)}, pen);
    CHECK(with_noise.levels() == stroked({pixels(2, 12), pixels(22, 12)}, pen).levels());
}

TEST_CASE("random round strokes are where the pen has been")
{
    std::mt19937 random{41};
    std::uniform_real_distribution<double> coordinate{2, 22};
    double worst = 0;
    for (int round = 0; round < rounds(25); ++round) {
        std::vector<Point> points(2 + random() % 5);
        for (Point& point : points)
            point = pixels(coordinate(random), coordinate(random));
        const double width = 1 + static_cast<double>(random() % 40) / 8;
        const auto picture =
            stroked(points, {.half_width = half_width(width), .cap = Cap::round, .join = Join::round});
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x)
                worst =
                    std::max(worst, std::abs(picture.at(x, y) - level_by_distance(points, width / 2, x, y)));
    }
    CHECK(worst < 12 + raster::full_coverage / 16); // the sampling itself is as coarse as 12
}

}
