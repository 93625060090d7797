#pragma once

#include "tests/core/array_drawing.hpp"
#include "tests/core/raster/coverage_picture.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <doctest/doctest.h>
#include <random>
#include <vector>

/// Polygons, and pictures of them.
namespace kfast::test {

using Polygon = std::vector<raster::Corner>;

inline constexpr int full = raster::full_coverage;

inline Polygon polygon(const std::vector<Spot>& spots)
{
    Polygon corners;
    for (const Spot at : spots)
        corners.push_back(raster::corner_at(pixels(at.x, at.y)));
    return corners;
}

inline Polygon rectangle(double left, double top, double right, double bottom)
{
    return polygon({{left, top}, {right, top}, {right, bottom}, {left, bottom}});
}

inline Polygon reversed(Polygon polygon)
{
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

inline void add(CoveragePicture& picture, const std::vector<Polygon>& polygons)
{
    for (const Polygon& polygon : polygons) {
        for (const raster::Corner corner : polygon)
            picture.store().add(corner);
        picture.store().close();
    }
    REQUIRE(!picture.store().is_full());
}

inline CoveragePicture filled(Size size, const std::vector<Polygon>& polygons,
                              FillRule rule = FillRule::nonzero)
{
    CoveragePicture picture{size.width, size.height};
    add(picture, polygons);
    picture.draw(rule);
    return picture;
}

/// Corners from `low` to `high` px, on every n-th line of the grid.
inline Polygon random_polygon(std::mt19937& random, int low, int high, int columns = 1, int rows = 1)
{
    const auto coordinate = [&](int unit) {
        std::uniform_int_distribution<int> place{low * raster::grid / unit, high * raster::grid / unit};
        return place(random) * unit;
    };
    Polygon polygon(3 + random() % 5);
    for (raster::Corner& corner : polygon) {
        corner.x = coordinate(columns);
        corner.y = coordinate(rows);
    }
    return polygon;
}

inline Polygon random_triangle(std::mt19937& random, int low, int high, int rows = 1)
{
    Polygon triangle = random_polygon(random, low, high, 1, rows);
    triangle.resize(3);
    return triangle;
}

/// With slight bends at its sides.
inline Polygon disc(double x, double y, double radius)
{
    std::vector<Spot> spots(64);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(spots.size());
        spots[i] = {x + radius * std::cos(angle), y + radius * std::sin(angle)};
    }
    return polygon(spots);
}

TEST_CASE("a shape much larger than the picture covers all of it")
{
    for (const Size size : {Size{5, 3}, Size{130, 90}, Size{600, 3}, Size{3, 600}}) {
        const auto count = static_cast<std::size_t>(size.width * size.height);
        const Polygon large = rectangle(-16000, -16000, 16000, 16000);
        CHECK(filled(size, {large}).levels() == std::vector<int>(count, full));
        CHECK(filled(size, {reversed(large)}).levels() == std::vector<int>(count, full));
        CHECK(filled(size, {large, large}, FillRule::even_odd).levels() == std::vector<int>(count, 0));
    }
}

/// One or the other in turn.
inline FillRule rule_of(int round) { return round % 2 == 0 ? FillRule::nonzero : FillRule::even_odd; }

}
