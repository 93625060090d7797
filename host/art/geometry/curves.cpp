#include "host/art/geometry/curves.hpp"

#include <algorithm>
#include <cmath>
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
    // The difference of two cubics is a cubic, which is within the hull of its control points; those of its
    // halves are nearer.
    return std::max(farthest(apart.between(0, 0.5)), farthest(apart.between(0.5, 1)));
}

void CubicFit::take(double parameter, Vec2 spot, double weight)
{
    const double rest = 1 - parameter;
    const double at_first = 3 * rest * rest * parameter; // the weights of the two control points
    const double at_last = 3 * rest * parameter * parameter;
    const double begin = rest * rest * rest + at_first;
    const Vec2 miss = spot - (begin * from_ + (1 - begin) * to_);
    first_ += weight * at_first * at_first;
    both_ += weight * at_first * at_last;
    last_ += weight * at_last * at_last;
    towards_first_ = towards_first_ + weight * at_first * miss;
    towards_last_ = towards_last_ + weight * at_last * miss;
}

CubicPiece CubicFit::free() const
{
    const double determinant = first_ * last_ - both_ * both_;
    const Vec2 first = 1 / determinant * (last_ * towards_first_ - both_ * towards_last_);
    const Vec2 last = 1 / determinant * (first_ * towards_last_ - both_ * towards_first_);
    return {{from_, from_ + first, to_ + last, to_}};
}

CubicPiece CubicFit::along(Vec2 first, Vec2 last) const
{
    first = 1 / distance({}, first) * first;
    last = -1 / distance({}, last) * last;
    const double both = both_ * dot(first, last);
    const double determinant = first_ * last_ - both * both;
    const double towards_first = dot(towards_first_, first);
    const double towards_last = dot(towards_last_, last);
    return {{from_, from_ + (last_ * towards_first - both * towards_last) / determinant * first,
             to_ + (first_ * towards_last - both * towards_first) / determinant * last, to_}};
}

namespace {

using scene::Curve;

constexpr int pieces = 16;

double speed(Vec2 from, const Curve& curve, double t)
{
    const double rest = 1 - t;
    const Vec2 velocity = 3 * rest * rest * (curve.c1 - from) + 6 * rest * t * (curve.c2 - curve.c1) +
                          3 * t * t * (curve.to - curve.c2);
    return distance(Vec2{}, velocity);
}

/// The length of a cubic between two parameters, by the three-point Gauss-Legendre rule.
double piece_length(Vec2 from, const Curve& curve, double begin, double end)
{
    constexpr double offset = 0.774596669241483377; // the square root of 3/5
    const double middle = (begin + end) / 2;
    const double half = (end - begin) / 2;
    return half *
           (5 * speed(from, curve, middle - half * offset) + 8 * speed(from, curve, middle) +
            5 * speed(from, curve, middle + half * offset)) /
           9;
}

double length_until(Vec2 from, const Curve& curve, double parameter)
{
    double length = 0;
    for (int i = 0; i < pieces; ++i)
        length += piece_length(from, curve, parameter * i / pieces, parameter * (i + 1) / pieces);
    return length;
}

}

double curve_length(Vec2 from, const Curve& curve)
{
    return curve.cubic ? length_until(from, curve, 1) : distance(from, curve.to);
}

double curve_parameter(Vec2 from, const Curve& curve, double length)
{
    const double whole = curve_length(from, curve);
    if (length <= 0 || length >= whole)
        return length <= 0 ? 0 : 1;
    double t = length / whole;
    if (!curve.cubic)
        return t;
    double low = 0;
    double high = 1;
    for (int step = 0; step < 40; ++step) {
        const double off = length_until(from, curve, t) - length;
        if (std::abs(off) < 1e-10 * whole)
            break;
        (off < 0 ? low : high) = t;
        // By Newton's method, or by bisection where that diverges.
        const double next = t - off / speed(from, curve, t);
        t = next > low && next < high ? next : (low + high) / 2;
    }
    return t;
}

Vec2 spot_on(Vec2 from, const Curve& curve, double t)
{
    if (!curve.cubic)
        return (1 - t) * from + t * curve.to;
    const double rest = 1 - t;
    return rest * rest * rest * from + 3 * rest * rest * t * curve.c1 + 3 * rest * t * t * curve.c2 +
           t * t * t * curve.to;
}

double outline_length(const scene::Outline& outline)
{
    double length = 0;
    Vec2 from = outline.from;
    for (const Curve& curve : outline.curves) {
        length += curve_length(from, curve);
        from = curve.to;
    }
    return length;
}

Vec2 spot_along(const scene::Outline& outline, double share)
{
    double left = share * outline_length(outline);
    Vec2 from = outline.from;
    if (share <= 0)
        return from;
    for (const Curve& curve : outline.curves) {
        const double length = curve_length(from, curve);
        if (left < length)
            return spot_on(from, curve, curve_parameter(from, curve, left));
        left -= length;
        from = curve.to;
    }
    return from;
}

}
