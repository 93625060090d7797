#include "host/svg/clip_cover.hpp"

#include "host/art/curve_length.hpp"

#include <algorithm>
#include <vector>

namespace kfast::svg {
namespace {

using scene::Spot;

/// Curves as 16 lines each.
std::vector<Spot> corners_of(const scene::Outline& outline)
{
    constexpr int steps = 16;
    std::vector<Spot> corners{outline.from};
    for (const scene::Curve& curve : outline.curves) {
        const Spot from = corners.back();
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

Sides sides_of(Spot place, const std::vector<Spot>& corners)
{
    constexpr double tolerance = 0.01;
    Sides sides;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Spot from = corners[i];
        const Spot to = corners[(i + 1) % corners.size()];
        const double length = scene::distance(from, to);
        const double beside = length > 0 ? scene::cross(to - from, place - from) / length : 0;
        sides.left = sides.left || beside < -tolerance;
        sides.right = sides.right || beside > tolerance;
    }
    return sides;
}

}

bool covers(const art::Drawing& area, std::span<const Spot> places)
{
    if (area.outlines.size() != 1 || area.outlines.front().curves.size() < 2)
        return false;
    const auto corners = corners_of(area.outlines.front());
    return std::ranges::all_of(places, [&](Spot place) {
        const Sides sides = sides_of(place, corners);
        return sides.left != sides.right;
    });
}

}
