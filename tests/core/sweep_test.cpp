#include "core/sweep.hpp"

#include "core/fill_outline.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/coverage_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <numeric>
#include <random>
#include <string>

namespace kfast::test {
namespace {

using Polygon = std::vector<Point>;

void fill(CoveragePicture& picture, const std::vector<Polygon>& polygons, FillRule rule = FillRule::nonzero)
{
    FillOutline outline{picture.store()};
    for (const Polygon& polygon : polygons) {
        outline.begin(polygon.front());
        for (const Point& point : polygon)
            outline.line_to(point);
        outline.end(polygon.front());
    }
    picture.draw(rule);
}

/// Where an edge passes a row of samples: what lies right of x is wound around once more or less.
struct Crossing {
    double x;
    int winding;
};

std::vector<Crossing> crossings(const std::vector<Polygon>& polygons, double y)
{
    std::vector<Crossing> found;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point& a = polygon[i];
            const Point& b = polygon[(i + 1) % polygon.size()];
            const double ay = a.y.raw() / 65536.0;
            const double by = b.y.raw() / 65536.0;
            if ((ay <= y) == (by <= y))
                continue;
            const double ax = a.x.raw() / 65536.0;
            const double bx = b.x.raw() / 65536.0;
            found.push_back({ax + (bx - ax) * (y - ay) / (by - ay), ay < by ? 1 : -1});
        }
    }
    return found;
}

int winding_at(const std::vector<Crossing>& row, double x)
{
    int winding = 0;
    for (const Crossing& crossing : row)
        winding += crossing.x < x ? crossing.winding : 0;
    return winding;
}

bool is_inside(int winding, FillRule rule)
{
    return rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
}

/// The covered share of a pixel from 32 x 32 samples, as a level.
double sampled_level(const std::vector<Polygon>& polygons, int x, int y, FillRule rule)
{
    constexpr int samples = 32;
    int inside = 0;
    for (int j = 0; j < samples; ++j) {
        const std::vector<Crossing> row = crossings(polygons, y + (j + 0.5) / samples);
        for (int i = 0; i < samples; ++i)
            inside += is_inside(winding_at(row, x + (i + 0.5) / samples), rule);
    }
    return inside * 255.0 / (samples * samples);
}

Polygon random_polygon(std::mt19937& random, double low, double high)
{
    std::uniform_real_distribution<double> coordinate{low, high};
    Polygon polygon(3 + random() % 5);
    for (Point& point : polygon)
        point = pixels(coordinate(random), coordinate(random));
    return polygon;
}

TEST_CASE("a rectangle on pixel borders covers its pixels wholly and no others")
{
    CoveragePicture picture{6, 4};
    fill(picture, {{pixels(1, 1), pixels(4, 1), pixels(4, 3), pixels(1, 3)}});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 6; ++x)
            CHECK(picture.at(x, y) == (x >= 1 && x < 4 && y >= 1 && y < 3 ? 255 : 0));
}

TEST_CASE("coverage is the exact area, in 256 levels")
{
    for (int part = 0; part <= 256; ++part) {
        CoveragePicture wide{1, 1};
        fill(wide, {{pixels(0, 0), pixels(part / 256.0, 0), pixels(part / 256.0, 1), pixels(0, 1)}});
        CoveragePicture high{1, 1};
        fill(high, {{pixels(0, 0), pixels(1, 0), pixels(1, part / 256.0), pixels(0, part / 256.0)}});
        const int expected = (part * 255 + 128) / 256;
        CHECK(wide.at(0, 0) == expected);
        CHECK(high.at(0, 0) == expected);
    }
}

TEST_CASE("a triangle over half a pixel covers half of it")
{
    CoveragePicture picture{1, 1};
    fill(picture, {{pixels(0, 0), pixels(1, 0), pixels(0, 1)}});
    CHECK(picture.at(0, 0) == 128);
}

TEST_CASE("outlines that overlap within a pixel are not counted twice")
{
    CoveragePicture picture{2, 1};
    const Polygon half{pixels(0, 0), pixels(0.5, 0), pixels(0.5, 1), pixels(0, 1)};
    fill(picture, {half, half, half});
    CHECK(picture.at(0, 0) == 128);
    CHECK(picture.at(1, 0) == 0);
}

TEST_CASE("outlines of opposite sense cancel where both wind, and fill where one does")
{
    CoveragePicture picture{4, 1};
    const Polygon right{pixels(0, 0), pixels(3, 0), pixels(3, 1), pixels(0, 1)};
    const Polygon left{pixels(1, 0), pixels(1, 1), pixels(4, 1), pixels(4, 0)};
    fill(picture, {right, left});
    CHECK(picture.levels() == std::vector<int>{255, 0, 0, 255});
}

TEST_CASE("by the rule even-odd, what an even number of outlines goes around is empty, whatever their sense")
{
    const Polygon outer{pixels(0, 0), pixels(5, 0), pixels(5, 1), pixels(0, 1)};
    const Polygon middle{pixels(1, 0), pixels(4, 0), pixels(4, 1), pixels(1, 1)};
    const Polygon inner{pixels(2, 0), pixels(2, 1), pixels(3, 1), pixels(3, 0)};
    CoveragePicture rings{5, 1};
    fill(rings, {outer, middle, inner}, FillRule::even_odd);
    CHECK(rings.levels() == std::vector<int>{255, 0, 255, 0, 255});
    CoveragePicture nothing{5, 1};
    fill(nothing, {outer, outer}, FillRule::even_odd);
    CHECK(nothing.levels() == std::vector<int>(5, 0));
}

TEST_CASE("what lies outside the picture does not leak into it")
{
    CoveragePicture picture{4, 4};
    fill(picture, {{pixels(-900, -50), pixels(-1, -50), pixels(-1, 900), pixels(-900, 900)},
                   {pixels(5, -700), pixels(900, -700), pixels(900, 700), pixels(5, 700)},
                   {pixels(-10, -9), pixels(20, -9), pixels(20, -1), pixels(-10, -1)},
                   {pixels(-10, 4), pixels(20, 4), pixels(20, 40), pixels(-10, 40)}});
    CHECK(picture.levels() == std::vector<int>(16, 0));
}

TEST_CASE("a shape much larger than the picture covers all of it")
{
    CoveragePicture picture{5, 3};
    fill(picture,
         {{pixels(-16000, -16000), pixels(16000, -16000), pixels(16000, 16000), pixels(-16000, 16000)}});
    CHECK(picture.levels() == std::vector<int>(15, 255));
}

TEST_CASE("random outlines have the coverage that dense sampling finds")
{
    std::mt19937 random{1};
    double worst = 0;
    for (int round = 0; round < 80; ++round) {
        const FillRule rule = round % 2 == 0 ? FillRule::nonzero : FillRule::even_odd;
        std::vector<Polygon> polygons(1 + random() % 3);
        for (Polygon& polygon : polygons)
            polygon = random_polygon(random, -3, 15);
        CoveragePicture picture{12, 12};
        fill(picture, polygons, rule);
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                worst = std::max(worst, std::abs(picture.at(x, y) - sampled_level(polygons, x, y, rule)));
    }
    CHECK(worst < 9); // the sampling itself is that coarse
}

TEST_CASE("a straight edge stays straight over a high panel")
{
    constexpr int rows = 480;
    for (const auto& [top, bottom] : {std::pair{1.0, 0.7}, {1.0, 3.3}, {1.0, 11.3}, {11.7, 0.9}}) {
        CoveragePicture picture{12, rows};
        fill(picture, {{pixels(0, 0), pixels(top, 0), pixels(bottom, rows), pixels(0, rows)}});
        double worst = 0;
        for (int row = 0; row < rows; ++row) {
            double covered = 0;
            for (int column = 0; column < 12; ++column)
                covered += picture.at(column, row);
            worst = std::max(worst, std::abs(covered - 255 * (top + (bottom - top) * (row + 0.5) / rows)));
        }
        CHECK(worst <= 1.5);
    }
}

TEST_CASE("a flat edge stays straight over a wide panel")
{
    constexpr int columns = 300;
    for (const double height : {0.3, 0.7, 1.0}) {
        CoveragePicture picture{columns, 1};
        fill(picture, {{pixels(0, 0), pixels(columns, height), pixels(0, height)}});
        double worst = 0;
        for (int x = 0; x < columns; ++x)
            worst = std::max(worst, std::abs(picture.at(x, 0) - 255 * height * (1 - (x + 0.5) / columns)));
        CHECK(worst <= 1.5);
    }
}

TEST_CASE("the order in which outlines are added changes nothing")
{
    std::mt19937 random{2};
    for (int round = 0; round < 200; ++round) {
        std::vector<Polygon> polygons(3);
        for (Polygon& polygon : polygons)
            polygon = random_polygon(random, -3, 15);
        CoveragePicture forwards{12, 12};
        fill(forwards, polygons);
        std::swap(polygons[0], polygons[2]);
        CoveragePicture backwards{12, 12};
        fill(backwards, polygons);
        for (std::size_t i = 0; i < forwards.levels().size(); ++i)
            CHECK(std::abs(forwards.levels()[i] - backwards.levels()[i]) <= 1);
    }
}

/// With slight bends at its sides.
Polygon disc(double x, double y, double radius)
{
    Polygon polygon(64);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(polygon.size());
        polygon[i] = pixels(x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    return polygon;
}

/// On whole pixels: chains begin and meet in the same places.
Polygon coarse_polygon(std::mt19937& random, int size)
{
    std::uniform_int_distribution<int> place{0, size};
    Polygon polygon(3 + random() % 5);
    for (Point& point : polygon)
        point = pixels(place(random), place(random));
    return polygon;
}

/// As from the top down, if each row is swept by itself, and in any order.
void expect_same_rows(const std::vector<Polygon>& polygons, int size, std::mt19937& random)
{
    CoveragePicture picture{size, size};
    fill(picture, polygons);
    const std::vector<int> expected = picture.levels();
    std::vector<int> rows(static_cast<std::size_t>(size));
    std::iota(rows.begin(), rows.end(), 0);
    std::reverse(rows.begin(), rows.end());
    picture.draw_rows(rows);
    REQUIRE(picture.levels() == expected);
    std::shuffle(rows.begin(), rows.end(), random);
    picture.draw_rows(rows);
    REQUIRE(picture.levels() == expected);
}

TEST_CASE("a row is the same however the sweep comes to it")
{
    std::mt19937 random{3};
    std::uniform_real_distribution<double> place{0, 60};
    for (int round = 0; round < 100; ++round) {
        std::vector<Polygon> polygons;
        for (std::size_t i = 0; i < 1 + random() % 6; ++i)
            polygons.push_back(random() % 4 == 0
                                   ? random_polygon(random, 0, 60)
                                   : disc(place(random), place(random), 12 + place(random) / 2));
        expect_same_rows(polygons, 60, random);
    }
    for (int round = 0; round < 500; ++round)
        expect_same_rows({coarse_polygon(random, 24), coarse_polygon(random, 24)}, 24, random);
    expect_same_rows({{pixels(5, 0), pixels(9, 20), pixels(31, 8), pixels(5, 13), pixels(26, 3)},
                      {pixels(27, 7), pixels(31.0625, 9.5), pixels(31.125, 14), pixels(27, 16.125)}},
                     40, random);
}

TEST_CASE("nothing is covered outside of a layer's columns, on however high a panel")
{
    constexpr int height = 480;
    std::mt19937 random{31};
    for (int round = 0; round < 60; ++round) {
        const auto x = [&random] {
            return Fixed::from_raw(static_cast<std::int32_t>(Fixed::pixels(4).raw() + random() % 131072));
        };
        CoveragePicture picture{10, height};
        fill(picture, {{{x(), {}}, {x(), Fixed::pixels(height)}, {x(), Fixed::pixels(3)}}});
        const Layer layer = layer_of(picture.store(), picture.store().range_from({}));
        for (int y = 0; y < height; ++y)
            for (int column = 0; column < picture.width(); ++column)
                if (picture.at(column, y) != 0)
                    REQUIRE((column >= layer.left && column < layer.right));
    }
}

TEST_CASE("lines across all that is held bend as they must")
{
    CoveragePicture picture{8, 3};
    fill(picture, {{pixels(-16383, 0.5), pixels(16383, 1.6), pixels(-16383, 2.7)}});
    CHECK(std::abs(picture.at(0, 1) - 255 * 95 / 100) <= 1); // from 1.05 on
}

TEST_CASE("a slight bend changes a pixel by less than 5 of 255")
{
    int worst = 0;
    for (int i = 0; i < 40; ++i) {
        const std::vector<Polygon> polygons{disc(20, 20, 12 + i / 8.0)};
        CoveragePicture picture{40, 40};
        fill(picture, polygons);
        for (int y = 0; y < 40; y += 3)
            for (int x = 0; x < 40; ++x)
                worst =
                    std::max(worst, std::abs(picture.at(x, y) - static_cast<int>(std::lround(sampled_level(
                                                                    polygons, x, y, FillRule::nonzero)))));
    }
    CHECK(worst < 12); // 8 are the samples'
}

}
}
