#include "host/geometry/shape.hpp"

#include "host/geometry/arc.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kfast::scene {

namespace {

/// 4/3 (sqrt 2 - 1): with control points this far along the tangents, a cubic meets a quarter circle at its
/// ends and in its middle.
constexpr double quarter_handle = 0.552284749830793398;

/// A quarter of an ellipse; `corner` is where the tangents of its ends meet.
Curve quarter(Vec2 from, Vec2 corner, Vec2 to)
{
    return cubic_to(from + quarter_handle * (corner - from), to + quarter_handle * (corner - to), to);
}

Outline rounded_rectangle(Vec2 low, Vec2 high, double rx, double ry)
{
    Outline outline{.from = {low.x + rx, low.y}, .curves = {}, .closed = true};
    const auto side_and_corner = [&](Vec2 side_end, Vec2 corner, Vec2 corner_end) {
        outline.curves.push_back(line_to(side_end));
        outline.curves.push_back(quarter(side_end, corner, corner_end));
    };
    side_and_corner({high.x - rx, low.y}, {high.x, low.y}, {high.x, low.y + ry});
    side_and_corner({high.x, high.y - ry}, high, {high.x - rx, high.y});
    side_and_corner({low.x + rx, high.y}, {low.x, high.y}, {low.x, high.y - ry});
    side_and_corner({low.x, low.y + ry}, low, {low.x + rx, low.y});
    return outline;
}

}

Outline ellipse(Vec2 centre, double radius_x, double radius_y)
{
    const Vec2 right{centre.x + radius_x, centre.y};
    const Vec2 bottom{centre.x, centre.y + radius_y};
    const Vec2 left{centre.x - radius_x, centre.y};
    const Vec2 top{centre.x, centre.y - radius_y};
    return {.from = right,
            .curves = {quarter(right, {right.x, bottom.y}, bottom), quarter(bottom, {left.x, bottom.y}, left),
                       quarter(left, {left.x, top.y}, top), quarter(top, {right.x, top.y}, right)},
            .closed = true};
}

Outline rectangle(Vec2 upper_left, double width, double height, double corner)
{
    const Vec2 high = upper_left + Vec2{width, height};
    if (corner > 0)
        return rounded_rectangle(upper_left, high, std::min(corner, width / 2), std::min(corner, height / 2));
    return {.from = upper_left,
            .curves = {line_to({high.x, upper_left.y}), line_to(high), line_to({upper_left.x, high.y})},
            .closed = true};
}

Outline polyline(std::span<const Vec2> spots, bool closed)
{
    Outline outline{.from = spots.front(), .curves = {}, .closed = closed};
    for (const Vec2& spot : spots.subspan(1))
        outline.curves.push_back(line_to(spot));
    return outline;
}

namespace {

constexpr double twelve_o_clock = -90;

}

Outline star(Vec2 centre, int tips, double outer, double inner, double rotation)
{
    std::vector<Vec2> spots;
    spots.reserve(static_cast<std::size_t>(2 * tips));
    for (int i = 0; i < 2 * tips; ++i)
        spots.push_back(centre + (i % 2 == 0 ? outer : inner) *
                                     on_unit_circle(twelve_o_clock + rotation + 180.0 * i / tips));
    return polyline(spots, true);
}

Outline regular_polygon(Vec2 centre, int corners, double radius, double rotation)
{
    std::vector<Vec2> spots;
    spots.reserve(static_cast<std::size_t>(corners));
    for (int i = 0; i < corners; ++i)
        spots.push_back(centre + radius * on_unit_circle(twelve_o_clock + rotation + 360.0 * i / corners));
    return polyline(spots, true);
}

namespace {

/// The step from one point to the next.
struct Step {
    double knots = 0; ///< the distance of its knots
    Vec2 slope;       ///< the mean slope, per knot
};

/// Uses square roots alone, for they are the same on every computer.
Step step(Vec2 from, Vec2 to)
{
    const Vec2 way = to - from;
    const double knots = std::sqrt(std::sqrt(way.x * way.x + way.y * way.y));
    return {knots, (1 / knots) * way};
}

bool same(Vec2 a, Vec2 b)
{
    const Vec2 way = b - a;
    return way.x * way.x + way.y * way.y == 0; // if the square is 0, so is the extent
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

/// The slope of the parabola through three points, at the middle one.
Vec2 middle_slope(const Step& before, const Step& after)
{
    return (1 / (before.knots + after.knots)) * (after.knots * before.slope + before.knots * after.slope);
}

/// The slope at each spot. A parabola's mean slope between two spots is the mean of the slopes at both.
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
