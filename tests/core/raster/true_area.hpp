#pragma once

#include "core/raster/outline/grid.hpp"
#include "tests/core/spot.hpp"

#include <cstddef>
#include <vector>

namespace kfast::test {

/// What of a polygon lies on one side of a line through `at`, along an axis: Sutherland and Hodgman's
/// clipping.
inline std::vector<Spot> cut(const std::vector<Spot>& polygon, double Spot::*along, double at, double sign)
{
    std::vector<Spot> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Spot a = polygon[i];
        const Spot b = polygon[(i + 1) % polygon.size()];
        const double from = sign * (a.*along - at);
        const double to = sign * (b.*along - at);
        if (from >= 0)
            kept.push_back(a);
        if ((from < 0) != (to < 0))
            kept.push_back(a + from / (from - to) * (b - a));
    }
    return kept;
}

/// How much of a pixel a polygon goes around, counted as often as it does: negative where it runs down on the
/// right.
inline double true_area(const std::vector<raster::Corner>& corners, int x, int y)
{
    std::vector<Spot> polygon;
    polygon.reserve(corners.size());
    for (const raster::Corner corner : corners)
        polygon.push_back(spot(corner));
    polygon = cut(polygon, &Spot::x, x, 1);
    polygon = cut(polygon, &Spot::x, x + 1, -1);
    polygon = cut(polygon, &Spot::y, y, 1);
    polygon = cut(polygon, &Spot::y, y + 1, -1);
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Spot a = polygon[i];
        const Spot b = polygon[(i + 1) % polygon.size()];
        area -= (a.x * b.y - b.x * a.y) / 2;
    }
    return area;
}

}
