#include "host/lottie/drawings/rounded_corners.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kfast::lottie {
namespace {

using scene::Outline;
using scene::Vec2;

/// Where curves meet, with the control points on both sides.
struct Vertex {
    Vec2 in;
    Vec2 at;
    Vec2 out;
};

bool is_same(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

bool is_corner(const Vertex& vertex)
{
    return is_same(vertex.in, vertex.at) && is_same(vertex.out, vertex.at);
}

std::vector<Vertex> vertices_of(const Outline& outline)
{
    std::vector<Vertex> vertices{{outline.from, outline.from, outline.from}};
    for (const scene::Curve& curve : outline.curves) {
        if (curve.cubic)
            vertices.back().out = curve.c1;
        vertices.push_back({curve.cubic ? curve.c2 : curve.to, curve.to, curve.to});
    }
    if (outline.closed && vertices.size() > 1 && is_same(vertices.back().at, outline.from)) {
        vertices.front().in = vertices.back().in;
        vertices.pop_back();
    }
    return vertices;
}

scene::Curve curve_between(const Vertex& from, const Vertex& to)
{
    if (is_same(from.out, from.at) && is_same(to.in, to.at))
        return scene::line_to(to.at);
    return scene::cubic_to(from.out, to.in, to.at);
}

Outline outline_of(const std::vector<Vertex>& vertices, bool closed)
{
    Outline outline{vertices.front().at, {}, closed};
    for (std::size_t i = 1; i < vertices.size(); ++i)
        outline.curves.push_back(curve_between(vertices[i - 1], vertices[i]));
    if (closed)
        outline.curves.push_back(curve_between(vertices.back(), vertices.front()));
    return outline;
}

/// From the corner along a side; the control point is where a cubic comes nearest to an arc.
Vertex towards(Vec2 corner, Vec2 neighbour, double radius, bool arc_follows)
{
    constexpr double handle = 0.552284749830793398;
    const double side = scene::distance(corner, neighbour);
    const double reach = std::min(radius, side / 2);
    const Vec2 at = side > 0 ? corner + reach / side * (neighbour - corner) : corner;
    const Vec2 control = at + handle * (corner - at);
    return arc_follows ? Vertex{at, at, control} : Vertex{control, at, at};
}

Outline rounded(const Outline& outline, double radius)
{
    const auto vertices = vertices_of(outline);
    const std::size_t count = vertices.size();
    std::vector<Vertex> result;
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_end = !outline.closed && (i == 0 || i == count - 1);
        if (is_end || !is_corner(vertices[i]) || count < 2) {
            result.push_back(vertices[i]);
            continue;
        }
        result.push_back(towards(vertices[i].at, vertices[(i + count - 1) % count].at, radius, true));
        result.push_back(towards(vertices[i].at, vertices[(i + 1) % count].at, radius, false));
    }
    return outline_of(result, outline.closed);
}

}

MovingDrawing with_rounded_corners(MovingDrawing drawing, const art::Channel& radius)
{
    if (radius.is_still() && radius.value() <= 0)
        return drawing;
    drawing.changes_form = drawing.changes_form || !drawing.moments.empty();
    drawing.moments.add(radius);
    drawing.cost *= 2;
    drawing.at = [radius, at = std::move(drawing.at)](double time) {
        art::Drawing result = at(time);
        for (Outline& outline : result.outlines)
            outline = rounded(outline, std::max(0.0, radius.at(time)));
        return result;
    };
    return drawing;
}

}
