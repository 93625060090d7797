#pragma once

#include "host/art/geometry/drawing.hpp"

#include <algorithm>
#include <vector>

namespace kfast::test {

/// Points along an outline, close to each other, a closed one back to its beginning.
inline std::vector<scene::Vec2> flattened(const scene::Outline& outline, int steps)
{
    std::vector<scene::Vec2> spots{outline.from};
    const auto add = [&](scene::Vec2 from, const scene::Curve& given) {
        const scene::Curve curve = art::as_cubic(from, given);
        for (int i = 1; i <= steps; ++i) {
            const double s = static_cast<double>(i) / steps;
            const double r = 1 - s;
            spots.push_back(r * r * r * from + 3 * r * r * s * curve.c1 + 3 * r * s * s * curve.c2 +
                            s * s * s * curve.to);
        }
    };
    scene::Vec2 from = outline.from;
    for (const scene::Curve& curve : outline.curves) {
        add(from, curve);
        from = curve.to;
    }
    if (outline.closed)
        add(from, scene::line_to(outline.from));
    return spots;
}

inline double distance_to_segment(scene::Vec2 spot, scene::Vec2 from, scene::Vec2 to)
{
    const scene::Vec2 way = to - from;
    const double square = dot(way, way);
    const double share = square > 0 ? std::clamp(dot(spot - from, way) / square, 0.0, 1.0) : 0;
    return distance(spot, from + share * way);
}

/// How far a point of one is from the other one, at most; those that belong to each other are met in order,
/// so that it is enough to look around the last place.
inline double farthest_point(const std::vector<scene::Vec2>& points, const std::vector<scene::Vec2>& line)
{
    constexpr std::size_t around = 80;
    double max = 0;
    std::size_t last = 0;
    for (const scene::Vec2 point : points) {
        double min = distance(point, line[last]);
        const std::size_t from = last > around ? last - around : 0;
        for (std::size_t i = from; i + 1 < std::min(line.size(), from + 2 * around); ++i)
            if (const double apart = distance_to_segment(point, line[i], line[i + 1]); apart < min) {
                min = apart;
                last = i;
            }
        max = std::max(max, min);
    }
    return max;
}

/// Hausdorff's distance of two drawings with the same outlines, but for how finely they are looked at.
inline double drawn_distance(const art::Drawing& left, const art::Drawing& right)
{
    constexpr std::size_t spots = 600;
    double max = 0;
    for (std::size_t i = 0; i < left.outlines.size(); ++i) {
        const auto fine = [](const scene::Outline& outline) {
            return flattened(outline, static_cast<int>(spots / (outline.curves.size() + 1) + 8));
        };
        const auto fine_left = fine(left.outlines[i]);
        const auto fine_right = fine(right.outlines[i]);
        max = std::max({max, farthest_point(fine_left, fine_right), farthest_point(fine_right, fine_left)});
    }
    return max;
}

}
