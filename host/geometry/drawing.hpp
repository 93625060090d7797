#pragma once

#include "core/scene/kfb_limits.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Drawings with every number rounded to what the binary stores.
namespace kfast::scene {

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
/// points in one place.
struct Stroke {
    Point from;
    std::vector<Segment> segments;
    friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// May be empty: the object is not seen.
struct Drawing {
    std::vector<Stroke> strokes;
    friend bool operator==(const Drawing&, const Drawing&) = default;
};

/// As the format counts them: one where a stroke begins and one for each of its segments.
inline std::size_t point_count(const Drawing& drawing)
{
    std::size_t points = drawing.strokes.size();
    for (const Stroke& stroke : drawing.strokes)
        points += stroke.segments.size();
    return points;
}

/// In a drawing: one where a stroke begins and one for each of its segments.
inline constexpr std::size_t max_points = kfb::max_drawing_points;

inline std::string too_many_points()
{
    return "a drawing holds at most " + std::to_string(max_points) + " points";
}

}
