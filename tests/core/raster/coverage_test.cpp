#include "core/raster/outline/object_outline.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/raster/polygons.hpp"
#include "tests/core/raster/true_area.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

/// What it changes in a pixel that crossings lie on the grid, where it has two edges.
constexpr double grid_error = full / double{raster::grid};
/// What corners of a chain that are dropped may change besides.
constexpr double bend_error = full / 16.0;

/// Where an edge passes a row of samples: what lies right of x is wound around once more or less.
struct EdgeCrossing {
    double x;
    int winding;
};

std::vector<EdgeCrossing> edge_crossings(const std::vector<Polygon>& polygons, double y)
{
    std::vector<EdgeCrossing> found;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Spot a = spot(polygon[i]);
            const Spot b = spot(polygon[(i + 1) % polygon.size()]);
            if ((a.y <= y) == (b.y <= y))
                continue;
            found.push_back({a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), a.y < b.y ? 1 : -1});
        }
    }
    return found;
}

int winding_at(const std::vector<EdgeCrossing>& row, double x)
{
    int winding = 0;
    for (const EdgeCrossing& crossing : row)
        winding += crossing.x < x ? crossing.winding : 0;
    return winding;
}

bool is_inside(int winding, FillRule rule)
{
    return rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
}

/// Of 32 x 32 samples of a pixel.
struct SampledPixel {
    double coverage; ///< 0 ... 256
    int min;         ///< winding number
    int max;

    /// Whether outlines overlap within it so that their areas do not tell the coverage.
    bool has_overlaps(FillRule rule) const
    {
        return max - min > 1 || (rule == FillRule::nonzero && min < 0 && max > 0);
    }
};

SampledPixel sampled(const std::vector<Polygon>& polygons, int x, int y, FillRule rule)
{
    constexpr int samples = 32;
    int inside = 0;
    SampledPixel pixel{0, 99, -99};
    for (int j = 0; j < samples; ++j) {
        const std::vector<EdgeCrossing> row = edge_crossings(polygons, y + (j + 0.5) / samples);
        for (int i = 0; i < samples; ++i) {
            const int winding = winding_at(row, x + (i + 0.5) / samples);
            inside += is_inside(winding, rule);
            pixel.min = std::min(pixel.min, winding);
            pixel.max = std::max(pixel.max, winding);
        }
    }
    pixel.coverage = inside * double{full} / (samples * samples);
    return pixel;
}

/// What the areas within a pixel add up to.
double summed_up(const std::vector<Polygon>& polygons, int x, int y, FillRule rule)
{
    double area = 0;
    for (const Polygon& polygon : polygons)
        area += true_area(polygon, x, y);
    area = std::abs(area);
    if (rule == FillRule::even_odd) {
        area = std::fmod(area, 2);
        area = std::min(area, 2 - area);
    }
    return full * std::min(area, 1.0);
}

/// How far a picture is from what the areas add up to.
double worst_error(const CoveragePicture& picture, const std::vector<Polygon>& polygons,
                   FillRule rule = FillRule::nonzero)
{
    double worst = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            worst = std::max(worst, std::abs(picture.at(x, y) - summed_up(polygons, x, y, rule)));
    return worst;
}

TEST_CASE("a rectangle on pixel borders covers its pixels wholly and no others")
{
    const CoveragePicture picture = filled({70, 9}, {rectangle(1, 1, 67, 7)});
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 70; ++x)
            CHECK(picture.at(x, y) == (x >= 1 && x < 67 && y >= 1 && y < 7 ? full : 0));
}

TEST_CASE("coverage is the exact area of what lies on the grid")
{
    for (int part = 0; part <= raster::grid; ++part) {
        const double length = part / double{raster::grid};
        CHECK(filled({1, 1}, {rectangle(0, 0, length, 1)}).at(0, 0) == 4 * part);
        CHECK(filled({3, 2}, {rectangle(1 - length, 1, 2, 2)}).at(0, 1) == 4 * part);
        if (part <= raster::grid / 16) // corners so near to a border may be dropped
            continue;
        CHECK(filled({1, 1}, {rectangle(0, 0, 1, length)}).at(0, 0) == 4 * part);
        CHECK(filled({3, 2}, {rectangle(1, 1 - length, 2, 2)}).at(1, 0) == 4 * part);
    }
}

TEST_CASE("of what is lower than 1/16 px, no more is lost than that")
{
    for (int part = 0; part <= raster::grid / 16; ++part)
        for (int above = 0; above <= raster::grid; ++above) {
            const double top = above / 64.0;
            const CoveragePicture low = filled({9, 3}, {rectangle(1, top, 8, top + part / 64.0)});
            for (int x = 0; x < 9; ++x) {
                const int covered = low.at(x, 0) + low.at(x, 1) + low.at(x, 2);
                CHECK(covered <= 4 * part);
                CHECK((x != 0 || covered == 0));
                CHECK((x != 8 || covered == 0));
            }
        }
}

TEST_CASE("a triangle over half a pixel covers half of it")
{
    CHECK(filled({1, 1}, {polygon({{0, 0}, {1, 0}, {0, 1}})}).at(0, 0) == full / 2);
    CHECK(filled({2, 3}, {polygon({{1, 1}, {2, 1}, {2, 2}})}).levels() ==
          std::vector<int>{0, 0, 0, full / 2, 0, 0});
}

TEST_CASE("outlines that overlap within a pixel are not counted twice")
{
    const Polygon quarter = rectangle(0, 0, 0.25, 1);
    const Polygon half = rectangle(0, 0, 0.5, 1);
    const std::vector<Polygon> many(6, quarter);
    CHECK(filled({2, 1}, {quarter, quarter}).levels() == std::vector<int>{full / 4, 0});
    CHECK(filled({2, 1}, {half, quarter, half}).levels() == std::vector<int>{full / 2, 0});
    CHECK(filled({2, 1}, {quarter, reversed(quarter)}).levels() == std::vector<int>{0, 0});
    CHECK(filled({2, 1}, {half, quarter}, FillRule::even_odd).levels() == std::vector<int>{full / 4, 0});
    CHECK(filled({2, 1}, {half, half, half}, FillRule::even_odd).levels() == std::vector<int>{full / 2, 0});
    CHECK(filled({2, 1}, many).levels() == std::vector<int>{full / 4, 0});
}

TEST_CASE("where outlines overlap over whole pixels, these are not counted twice")
{
    const Polygon wide = rectangle(0, 0, 3, 1);
    const Polygon rest = rectangle(1, 0, 4, 1);
    CHECK(filled({5, 1}, {wide, rest, wide}).levels() == std::vector<int>{full, full, full, full, 0});
}

TEST_CASE("outlines of opposite sense cancel where both wind, and fill where one does")
{
    const std::vector<Polygon> both{rectangle(0, 0, 3, 1), reversed(rectangle(1, 0, 4, 1))};
    CHECK(filled({4, 1}, both).levels() == std::vector<int>{full, 0, 0, full});
}

TEST_CASE("by the rule even-odd, what an even number of outlines goes around is empty, whatever their sense")
{
    const Polygon outer = rectangle(0, 0, 5, 1);
    const Polygon middle = rectangle(1, 0, 4, 1);
    const Polygon inner = reversed(rectangle(2, 0, 3, 1));
    CHECK(filled({5, 1}, {outer, middle, inner}, FillRule::even_odd).levels() ==
          std::vector<int>{full, 0, full, 0, full});
    CHECK(filled({5, 1}, {outer, outer}, FillRule::even_odd).levels() == std::vector<int>(5, 0));
}

TEST_CASE("what lies outside the picture does not leak into it")
{
    for (const Size size : {Size{4, 4}, Size{70, 9}, Size{600, 3}}) {
        const int right = size.width;
        const int bottom = size.height;
        CHECK(filled(size, {rectangle(-900, -50, -1, 900), rectangle(right + 1, -700, right + 900, 700),
                            rectangle(-10, -9, right + 16, -1), rectangle(-10, bottom, right + 16, 40),
                            rectangle(-900, -50, 0, 900), rectangle(right, -700, right + 900, 700)})
                  .levels() == std::vector<int>(static_cast<std::size_t>(right * bottom), 0));
    }
}

TEST_CASE("random outlines have the coverage that dense sampling finds")
{
    std::mt19937 random{1};
    double worst = 0;
    double worst_where_overlapping = 0;
    for (int round = 0; round < rounds(240); ++round) {
        std::vector<Polygon> polygons(1 + random() % 3);
        for (Polygon& polygon : polygons)
            polygon = random_polygon(random, -3, 15);
        const CoveragePicture picture = filled({12, 12}, polygons, rule_of(round));
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x) {
                const SampledPixel expected = sampled(polygons, x, y, rule_of(round));
                double& max = expected.has_overlaps(rule_of(round)) ? worst_where_overlapping : worst;
                max = std::max(max, std::abs(picture.at(x, y) - expected.coverage));
            }
    }
    CHECK(worst < 9 + bend_error); // the sampling itself is as coarse as 9
    CHECK(worst_where_overlapping < 9 + bend_error);
}

TEST_CASE("edges between borders of rows add up their areas, but for the grid")
{
    std::mt19937 random{4};
    double worst = 0;
    for (int round = 0; round < rounds(300); ++round) {
        const std::vector<Polygon> one{random_triangle(random, -3, 75, raster::grid)};
        worst = std::max(worst, worst_error(filled({72, 72}, one, rule_of(round)), one, rule_of(round)));
    }
    CHECK(worst <= 1.5 * grid_error); // three edges meet at a corner
}

/// How much of a pixel of the first row is inside: the mean of 256 lines, each measured exactly.
double measured(const std::vector<Polygon>& polygons, int x, FillRule rule)
{
    constexpr int lines = 256;
    double length = 0;
    for (int line = 0; line < lines; ++line) {
        std::vector<EdgeCrossing> row = edge_crossings(polygons, (line + 0.5) / lines);
        std::ranges::sort(row, {}, &EdgeCrossing::x);
        int winding = 0;
        double begin = 0;
        for (const EdgeCrossing& crossing : row) {
            if (is_inside(winding, rule))
                length += std::clamp<double>(crossing.x, x, x + 1) - std::clamp<double>(begin, x, x + 1);
            winding += crossing.winding;
            begin = crossing.x;
        }
    }
    return full * length / lines;
}

double worst_error_of_row(const std::vector<Polygon>& polygons, int columns, FillRule rule)
{
    const CoveragePicture picture = filled({columns, 1}, polygons, rule);
    double worst = 0;
    for (int x = 0; x < columns; ++x)
        worst = std::max(worst, std::abs(picture.at(x, 0) - measured(polygons, x, rule)));
    return worst;
}

TEST_CASE("straight edges that cross within a row cover the area of what is inside")
{
    std::mt19937 random{8};
    std::uniform_real_distribution<double> place{0, 6};
    double worst = 0;
    for (int round = 0; round < rounds(1000); ++round) {
        std::vector<Polygon> polygons(2 + random() % 7); // no more than 16 edges
        for (Polygon& part : polygons)
            part = polygon({{place(random), 0}, {place(random), 0}, {place(random), 1}, {place(random), 1}});
        worst = std::max(worst, worst_error_of_row(polygons, 6, rule_of(round)));
    }
    CHECK(worst < 3);
}

TEST_CASE("straight edges that cross in one place cover the area of what is inside")
{
    std::mt19937 random{9};
    double worst = 0;
    for (int round = 0; round < rounds(300); ++round) {
        std::vector<Polygon> polygons(1 + random() % 8);
        for (Polygon& spokes : polygons) {
            const double left = 1 + static_cast<double>(random() % 64) / 32;
            const double right = 1 + static_cast<double>(random() % 64) / 32;
            spokes = polygon({{left, 0}, {right, 0}, {4 - left, 1}, {4 - right, 1}});
        }
        worst = std::max(worst, worst_error_of_row(polygons, 4, rule_of(round)));
    }
    CHECK(worst < 3);
}

TEST_CASE("the edges of triangles add up their areas, but for corners that are dropped")
{
    std::mt19937 random{5};
    double worst = 0;
    for (int round = 0; round < rounds(1000); ++round) {
        const std::vector<Polygon> one{random_triangle(random, -3, 15)};
        worst = std::max(worst, worst_error(filled({12, 12}, one, rule_of(round)), one, rule_of(round)));
    }
    CHECK(worst <= bend_error + grid_error);
}

TEST_CASE("a straight edge stays straight over a high panel")
{
    for (const double rows : {480.0, 900.0})
        for (const auto& [top, bottom] : {std::pair{1.0, 0.7}, {1.0, 3.3}, {1.0, 11.3}, {11.7, 0.9}}) {
            CAPTURE(rows);
            const Polygon part = polygon({{0, 0}, {top, 0}, {bottom, rows}, {0, rows}});
            const double left = spot(part[1]).x;
            const double right = spot(part[2]).x;
            const CoveragePicture picture = filled({12, static_cast<int>(rows)}, {part});
            double worst = 0;
            for (int row = 0; row < rows; ++row) {
                double covered = 0;
                for (int column = 0; column < 12; ++column)
                    covered += picture.at(column, row);
                worst =
                    std::max(worst, std::abs(covered - full * (left + (right - left) * (row + 0.5) / rows)));
            }
            CHECK(worst <= grid_error / 2 + grid_error * rows / 1024);
        }
}

TEST_CASE("a flat edge stays straight over a wide panel")
{
    constexpr int columns = 300;
    for (const double height : {0.3, 0.7, 1.0}) {
        const std::vector<Polygon> flat{polygon({{0, 0}, {columns, height}, {0, height}})};
        const double worst = worst_error(filled({columns, 1}, flat), flat);
        CHECK(worst <= 1.5);
    }
}

TEST_CASE("the order and the first corners of outlines change nothing")
{
    std::mt19937 random{2};
    for (int round = 0; round < rounds(200); ++round) {
        std::vector<Polygon> polygons(3);
        for (Polygon& polygon : polygons)
            polygon = random_polygon(random, -3, 15);
        const CoveragePicture forwards = filled({12, 12}, polygons);
        std::swap(polygons[0], polygons[2]);
        for (Polygon& polygon : polygons)
            std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
        CHECK(filled({12, 12}, polygons).levels() == forwards.levels());
    }
}

TEST_CASE("the sense of an outline changes nothing but how its areas are rounded")
{
    std::mt19937 random{6};
    for (int round = 0; round < rounds(200); ++round) {
        const Polygon triangle = random_triangle(random, -3, 15);
        const CoveragePicture one = filled({12, 12}, {triangle}, rule_of(round));
        const CoveragePicture other = filled({12, 12}, {reversed(triangle)}, rule_of(round));
        for (std::size_t i = 0; i < one.levels().size(); ++i)
            CHECK(std::abs(one.levels()[i] - other.levels()[i]) <= 1);
    }
}

TEST_CASE("two sides of a tip that cross where one of them bends are no more than what is inside")
{
    const std::vector<Polygon> crossed{
        polygon({{12, 0}, {8.5, 4 + 34 / 64.0}, {21, 4 + 34 / 64.0}, {2, 4}, {2, 0}})};
    for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd})
        CHECK(std::abs(filled({24, 8}, crossed, rule).at(8, 4) - 70) <= 24); // by eight lines
}

TEST_CASE("any number of edges in a few pixels cover no more than what is inside")
{
    constexpr int spikes = 60;
    const auto star = [](double turn) {
        std::vector<Spot> corners;
        for (int i = 0; i < 2 * spikes; ++i) {
            const double angle = turn + i * 3.14159265 / spikes;
            const double radius = i % 2 == 0 ? 2.4 : 0.6;
            corners.push_back({3 + radius * std::cos(angle), 3 + radius * std::sin(angle)});
        }
        return polygon(corners);
    };
    const std::vector<Polygon> two{star(0), star(0.013)}; // windings of 2, so that areas do not add up
    for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
        const CoveragePicture picture = filled({6, 6}, two, rule);
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 6; ++x)
                CHECK(std::abs(picture.at(x, y) - sampled(two, x, y, rule).coverage) <= 32);
    }
}

TEST_CASE("lines across all that is held bend as they must")
{
    const Polygon wedge = polygon({{-16383, 0.5}, {16383, 1.6}, {-16383, 2.7}});
    CHECK(std::abs(filled({8, 3}, {wedge}).at(0, 1) - full * 95 / 100) <= grid_error); // from 1.05 on
}

}
}
