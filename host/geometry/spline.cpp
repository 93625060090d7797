#include "host/geometry/spline.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace kfast::scene {
namespace {

/// The way from one spot to the next.
struct Step {
    double knots = 0; ///< the distance of its knots
    Vec2 slope;       ///< the mean slope, per knot
};

/// Square roots alone, for they are the same on every computer.
Step step(Vec2 from, Vec2 to)
{
    const Vec2 way = to - from;
    const double knots = std::sqrt(std::sqrt(way.x * way.x + way.y * way.y));
    return {knots, (1 / knots) * way};
}

bool same(Vec2 a, Vec2 b)
{
    const Vec2 way = b - a;
    return way.x * way.x + way.y * way.y == 0; // what is too near to have a square has no extent either
}

std::vector<Vec2> without_repetitions(std::span<const Vec2> spots, bool closed)
{
    std::vector<Vec2> kept;
    for (const Vec2& spot : spots)
        if (kept.empty() || !same(kept.back(), spot))
            kept.push_back(spot);
    while (closed && kept.size() > 1 && same(kept.front(), kept.back()))
        kept.pop_back();
    return kept;
}

std::vector<Step> steps_through(std::span<const Vec2> spots, bool closed)
{
    std::vector<Step> steps;
    for (std::size_t i = 0; i + 1 < spots.size(); ++i)
        steps.push_back(step(spots[i], spots[i + 1]));
    if (closed)
        steps.push_back(step(spots.back(), spots.front()));
    return steps;
}

/// Of the parabola through three spots, at the one in the middle.
Vec2 middle_slope(const Step& before, const Step& after)
{
    return (1 / (before.knots + after.knots)) * (after.knots * before.slope + before.knots * after.slope);
}

/// The slope at each spot. The mean slope of a parabola between two spots is the mean of the slopes at both.
std::vector<Vec2> slopes_at_spots(std::span<const Step> steps, bool closed)
{
    std::vector<Vec2> slopes;
    for (std::size_t i = 1; i < steps.size(); ++i)
        slopes.push_back(middle_slope(steps[i - 1], steps[i]));
    const Vec2 first =
        closed ? middle_slope(steps.back(), steps.front()) : 2.0 * steps.front().slope - slopes.front();
    if (!closed)
        slopes.push_back(2.0 * steps.back().slope - slopes.back());
    slopes.insert(slopes.begin(), first);
    return slopes;
}

}

Outline spline(std::span<const Vec2> spots, bool closed)
{
    const std::vector<Vec2> kept = without_repetitions(spots, closed);
    Outline outline{.from = kept.front(), .curves = {}, .closed = closed};
    if (kept.size() < 3) {
        outline.curves.push_back(line_to(kept.back()));
        return outline;
    }
    const std::vector<Step> steps = steps_through(kept, closed);
    const std::vector<Vec2> slopes = slopes_at_spots(steps, closed);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::size_t next = (i + 1) % kept.size();
        const double third = steps[i].knots / 3;
        outline.curves.push_back(
            cubic_to(kept[i] + third * slopes[i], kept[next] - third * slopes[next], kept[next]));
    }
    return outline;
}

}
