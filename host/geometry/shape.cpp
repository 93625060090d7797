#include "host/geometry/shape.hpp"

#include <algorithm>

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

}
