#include "host/svg/parts/clip_cover.hpp"

#include "host/art/geometry/curve_length.hpp"

#include <algorithm>
#include <vector>

namespace kfast::svg {
namespace {

using scene::Vec2;

/// Curves as 16 lines each.
std::vector<Vec2> corners_of(const scene::Outline& outline)
{
    constexpr int steps = 16;
    std::vector<Vec2> corners{outline.from};
    for (const scene::Curve& curve : outline.curves) {
        const Vec2 from = corners.back();
        for (int step = curve.cubic ? 1 : steps; step <= steps; ++step)
            corners.push_back(art::spot_on(from, curve, static_cast<double>(step) / steps));
    }
    return corners;
}

/// On which sides of the area's edges a place lies: both, where it lies outside.
struct Sides {
    bool left = false;
    bool right = false;
};

Sides sides_of(Vec2 place, const std::vector<Vec2>& corners)
{
    constexpr double tolerance = 0.01;
    Sides sides;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i];
        const Vec2 to = corners[(i + 1) % corners.size()];
        const double length = scene::distance(from, to);
        const double beside = length > 0 ? scene::cross(to - from, place - from) / length : 0;
        sides.left = sides.left || beside < -tolerance;
        sides.right = sides.right || beside > tolerance;
    }
    return sides;
}

bool lie_inside(std::span<const Vec2> places, const std::vector<Vec2>& corners)
{
    return std::ranges::all_of(places, [&](Vec2 place) {
        const Sides sides = sides_of(place, corners);
        return sides.left != sides.right;
    });
}

}

std::optional<std::vector<Vec2>> convex_corners(const art::Drawing& drawing)
{
    if (drawing.outlines.size() != 1 || drawing.outlines.front().curves.size() < 2)
        return std::nullopt;
    auto corners = corners_of(drawing.outlines.front());
    if (scene::distance(corners.front(), corners.back()) <= 0)
        corners.pop_back();
    constexpr std::size_t max = 1024; // they are compared with each other
    return corners.size() <= max && lie_inside(corners, corners) ? std::optional{corners} : std::nullopt;
}

bool covers(const art::Drawing& area, std::span<const Vec2> places)
{
    const auto corners = convex_corners(area);
    return corners && lie_inside(places, *corners);
}

}
