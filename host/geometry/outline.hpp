#pragma once

#include "host/geometry/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace kfast::scene {

/// A point on the canvas before rounding, in pixels.
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

/// The distance from `spot` to the nearest point between `from` and `to`.
inline double distance_to_line(Vec2 spot, Vec2 from, Vec2 to)
{
    const Vec2 along = to - from;
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(spot - from, along) / square, 0.0, 1.0) : 0;
    return distance(spot, from + share * along);
}

/// A line or a cubic Bézier from wherever the one before it ended; lines ignore c1 and c2.
struct Curve {
    bool cubic = false;
    Vec2 c1;
    Vec2 c2;
    Vec2 to;
};

constexpr Curve line_to(Vec2 to) { return {.cubic = false, .c1 = {}, .c2 = {}, .to = to}; }

constexpr Curve cubic_to(Vec2 c1, Vec2 c2, Vec2 to) { return {.cubic = true, .c1 = c1, .c2 = c2, .to = to}; }

/// The cubic that is the same curve as a quadratic Bézier.
constexpr Curve quadratic_to(Vec2 from, Vec2 control, Vec2 to)
{
    return cubic_to(from + 2.0 / 3 * (control - from), to + 2.0 / 3 * (control - to), to);
}

/// The sector between two directions from the centre of an ellipse whose axes are along x and y. Degrees,
/// from three o'clock, clockwise on the screen; if `to` is less than `from` it runs in the other direction.
struct Sector {
    Vec2 centre;
    double radius_x = 0; ///< pixels
    double radius_y = 0;
    double from = 0;
    double to = 0;
};

/// A stroke before rounding.
struct Outline {
    Vec2 from;
    std::vector<Curve> curves;
    bool closed = false;               ///< ends where it began, by a line of its own if need be
    std::optional<Sector> sector = {}; ///< that it surrounds, or runs along
    bool begins_letter = false;        ///< the first one of a letter of a text
};

bool in_range(Vec2 spot);
bool in_range(const Curve& curve);
bool in_range(const Outline& outline);

/// Rounds every point once, to the nearest 1/16 px (halves away from zero). Drops segments without extent
/// after that, down to a single point. Only for outlines that are in_range().
Stroke quantized(const Outline& outline);

}
