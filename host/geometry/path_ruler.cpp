#include "host/geometry/path_ruler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kfast::scene {
namespace {

constexpr int chords = 256;

Vec2 point_of(Vec2 from, const Curve& curve, double t)
{
    const double u = 1 - t;
    return u * u * u * from + 3 * u * u * t * curve.c1 + 3 * u * t * t * curve.c2 + t * t * t * curve.to;
}

}

PathRuler::PathRuler(const Outline& outline)
    : corners_{outline.from}, distances_{0}, is_closed_{outline.closed}
{
    for (const Curve& curve : outline.curves) {
        const Vec2 from = corners_.back();
        for (int chord = 1; curve.cubic && chord < chords; ++chord)
            add(point_of(from, curve, static_cast<double>(chord) / chords));
        add(curve.to);
    }
    if (is_closed_)
        add(outline.from);
}

void PathRuler::add(Vec2 corner)
{
    const double length = distance(corners_.back(), corner);
    if (length == 0)
        return;
    corners_.push_back(corner);
    distances_.push_back(distances_.back() + length);
}

PathPlace PathRuler::at(double distance) const
{
    if (is_closed_)
        distance -= std::floor(distance / length()) * length();
    const auto inner_end = distances_.end() - 1;
    const auto next = std::upper_bound(distances_.begin() + 1, inner_end, distance);
    const auto i = static_cast<std::size_t>(next - distances_.begin());
    const double size = distances_[i] - distances_[i - 1];
    const Vec2 direction = 1 / size * (corners_[i] - corners_[i - 1]);
    return {corners_[i - 1] + (distance - distances_[i - 1]) * direction, direction};
}

}
