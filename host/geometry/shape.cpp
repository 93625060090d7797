#include "host/geometry/shape.hpp"

#include <algorithm>

namespace kfast::scene {
namespace {

/// 4/3 (sqrt 2 - 1): with control points this far along the tangents, a cubic meets a quarter circle at its
/// ends and in its middle.
constexpr double quarter_handle = 0.552284749830793398;

/// A quarter of an ellipse; `corner` is where the tangents of its ends meet.
Curve quarter(Spot from, Spot corner, Spot to)
{
    return cubic_to(from + quarter_handle * (corner - from), to + quarter_handle * (corner - to), to);
}

Outline rounded_rectangle(Spot low, Spot high, double rx, double ry)
{
    Outline outline{.from = {low.x + rx, low.y}, .curves = {}, .closed = true};
    const auto side_and_corner = [&](Spot side_end, Spot corner, Spot corner_end) {
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

Outline ellipse(Spot centre, double radius_x, double radius_y)
{
    const Spot right{centre.x + radius_x, centre.y};
    const Spot bottom{centre.x, centre.y + radius_y};
    const Spot left{centre.x - radius_x, centre.y};
    const Spot top{centre.x, centre.y - radius_y};
    return {.from = right,
            .curves = {quarter(right, {right.x, bottom.y}, bottom), quarter(bottom, {left.x, bottom.y}, left),
                       quarter(left, {left.x, top.y}, top), quarter(top, {right.x, top.y}, right)},
            .closed = true};
}

Outline rectangle(Spot upper_left, double width, double height, double corner)
{
    const Spot high = upper_left + Spot{width, height};
    if (corner > 0)
        return rounded_rectangle(upper_left, high, std::min(corner, width / 2), std::min(corner, height / 2));
    return {.from = upper_left,
            .curves = {line_to({high.x, upper_left.y}), line_to(high), line_to({upper_left.x, high.y})},
            .closed = true};
}

Outline polyline(std::span<const Spot> spots, bool closed)
{
    Outline outline{.from = spots.front(), .curves = {}, .closed = closed};
    for (const Spot& spot : spots.subspan(1))
        outline.curves.push_back(line_to(spot));
    return outline;
}

}
