#pragma once

#include "core/math/point.hpp"
#include "core/raster/outline/grid.hpp"

#include <cmath>

namespace kfast::test {

/// A point in pixels, as exact as a double.
struct Spot {
    double x;
    double y;

    friend Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
    friend Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
    friend Spot operator*(double factor, Spot a) { return {factor * a.x, factor * a.y}; }
};

inline Spot spot(Point point) { return {point.x.raw() / 65536.0, point.y.raw() / 65536.0}; }
inline Spot spot(raster::Corner corner)
{
    return {corner.x / double{raster::grid}, corner.y / double{raster::grid}};
}

/// In pixels.
inline double apart(Point point, Spot exact)
{
    const Spot difference = spot(point) - exact;
    return std::hypot(difference.x, difference.y);
}

}
