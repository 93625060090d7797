#pragma once

#include "core/scene/kfb_limits.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast::scene {

/// Coordinates reach this many pixels to either side of the canvas' origin.
inline constexpr double coordinate_limit = 2047;

/// False for NaN, too.
constexpr bool in_range(double pixels) { return pixels >= -coordinate_limit && pixels <= coordinate_limit; }

/// Pixels in 1/16, rounded half away from zero. Only for pixels that are in_range().
inline std::int16_t to_sixteenths(double pixels)
{
    return static_cast<std::int16_t>(std::lround(pixels * 16));
}

/// Canvas pixels in 1/16.
struct Point {
    std::int16_t x = 0;
    std::int16_t y = 0;
    friend bool operator==(Point, Point) = default;
};

/// From the point before it to `to`; c1 and c2 are the control points of a cubic Bézier (0, 0 in a line).
struct Segment {
    bool cubic = false;
    Point c1;
    Point c2;
    Point to;
    friend bool operator==(const Segment&, const Segment&) = default;
};

/// Closed when its first and last point coincide. A single point has no segments; no segment has all of its
/// points coincide.
struct Stroke {
    Point from;
    std::vector<Segment> segments;
    friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// May be empty: then the object is not visible.
struct Drawing {
    std::vector<Stroke> strokes;
    friend bool operator==(const Drawing&, const Drawing&) = default;
};

/// Counts as the format does: one where a stroke begins and one for each of its segments.
inline std::size_t point_count(const Drawing& drawing)
{
    std::size_t points = drawing.strokes.size();
    for (const Stroke& stroke : drawing.strokes)
        points += stroke.segments.size();
    return points;
}

/// The limit of a drawing: one where a stroke begins and one for each of its segments.
inline constexpr std::size_t max_points = kfb::max_drawing_points;

inline std::string too_many_points()
{
    return "a drawing holds at most " + std::to_string(max_points) + " points";
}

}
