#include "host/art/geometry/cubic_piece.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast::art {
namespace {

using scene::Spot;

/// Bézier's polar form: the point of the curve if all three parameters are the same.
Spot polar(std::array<Spot, 4> points, const std::array<double, 3>& parameters)
{
    for (std::size_t round = 0; round < 3; ++round)
        for (std::size_t i = 0; i + round < 3; ++i)
            points[i] = points[i] + parameters[round] * (points[i + 1] - points[i]);
    return points[0];
}

double farthest(const CubicPiece& piece)
{
    double most = 0;
    for (const Spot& point : piece.points)
        most = std::max(most, dot(point, point));
    return std::sqrt(most);
}

bool is_way(Spot way) { return dot(way, way) > 1e-18; }

}

Spot CubicPiece::at(double parameter) const { return polar(points, {parameter, parameter, parameter}); }

CubicPiece CubicPiece::between(double from, double to) const
{
    return {{polar(points, {from, from, from}), polar(points, {from, from, to}),
             polar(points, {from, to, to}), polar(points, {to, to, to})}};
}

Spot CubicPiece::first_direction() const
{
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
        if (is_way(points[i] - points[0]))
            return points[i] - points[0];
    return chord();
}

Spot CubicPiece::last_direction() const
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
