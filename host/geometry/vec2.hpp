#pragma once

#include <algorithm>
#include <cmath>

namespace kfast::scene {

/// A place on the canvas before rounding, in pixels.
struct Vec2 {
    double x = 0;
    double y = 0;
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator*(double factor, Vec2 a) { return {factor * a.x, factor * a.y}; }
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Positive if `b` is to the right of `a` on a canvas, where y points down.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
// Not std::hypot, which platforms round differently.
inline double distance(Vec2 a, Vec2 b) { return std::sqrt(dot(b - a, b - a)); }

/// From `spot` to the nearest place between `from` and `to`.
inline double distance_to_line(Vec2 spot, Vec2 from, Vec2 to)
{
    const Vec2 along = to - from;
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(spot - from, along) / square, 0.0, 1.0) : 0;
    return distance(spot, from + share * along);
}

}
