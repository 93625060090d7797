#pragma once

#include <algorithm>
#include <cmath>

namespace kfast::scene {

/// A place on the canvas before rounding, in pixels.
struct Spot {
    double x = 0;
    double y = 0;
    friend constexpr Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Spot operator*(double factor, Spot a) { return {factor * a.x, factor * a.y}; }
};

constexpr double dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }
/// Positive if `b` is to the right of `a` on a canvas, where y points down.
constexpr double cross(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
// Not std::hypot, which platforms round differently.
inline double distance(Spot a, Spot b) { return std::sqrt(dot(b - a, b - a)); }

/// From `spot` to the nearest place between `from` and `to`.
inline double distance_to_line(Spot spot, Spot from, Spot to)
{
    const Spot along = to - from;
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(spot - from, along) / square, 0.0, 1.0) : 0;
    return distance(spot, from + share * along);
}

}
