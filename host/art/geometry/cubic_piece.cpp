#include "host/art/geometry/cubic_piece.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast::art {
namespace {

using scene::Vec2;

/// Bézier's polar form: the point of the curve if all three parameters are the same.
Vec2 polar(std::array<Vec2, 4> points, const std::array<double, 3>& parameters)
{
    for (std::size_t round = 0; round < 3; ++round)
        for (std::size_t i = 0; i + round < 3; ++i)
            points[i] = points[i] + parameters[round] * (points[i + 1] - points[i]);
    return points[0];
}

double farthest(const CubicPiece& piece)
{
    double max = 0;
    for (const Vec2& point : piece.points)
        max = std::max(max, dot(point, point));
    return std::sqrt(max);
}

bool is_way(Vec2 way) { return dot(way, way) > 1e-18; }

}

Vec2 CubicPiece::at(double parameter) const { return polar(points, {parameter, parameter, parameter}); }

CubicPiece CubicPiece::between(double from, double to) const
{
    return {{polar(points, {from, from, from}), polar(points, {from, from, to}),
             polar(points, {from, to, to}), polar(points, {to, to, to})}};
}

Vec2 CubicPiece::first_direction() const
{
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
        if (is_way(points[i] - points[0]))
            return points[i] - points[0];
    return chord();
}

Vec2 CubicPiece::last_direction() const
{
    for (const std::size_t i : {std::size_t{2}, std::size_t{1}})
        if (is_way(points[3] - points[i]))
            return points[3] - points[i];
    return chord();
}

double distance(const CubicPiece& left, const CubicPiece& right)
{
    CubicPiece apart;
    for (std::size_t i = 0; i < 4; ++i)
        apart.points[i] = left.points[i] - right.points[i];
    // The difference of two cubics is a cubic, which lies within its control points; those of its halves are
    // nearer to it.
    return std::max(farthest(apart.between(0, 0.5)), farthest(apart.between(0.5, 1)));
}

}
