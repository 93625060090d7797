#include "host/art/geometry/curve_length.hpp"

#include <cmath>

namespace kfast::art {
namespace {

using scene::Curve;
using scene::Vec2;

constexpr int pieces = 16;

double speed(Vec2 from, const Curve& curve, double t)
{
    const double rest = 1 - t;
    const Vec2 velocity = 3 * rest * rest * (curve.c1 - from) + 6 * rest * t * (curve.c2 - curve.c1) +
                          3 * t * t * (curve.to - curve.c2);
    return distance(Vec2{}, velocity);
}

/// Of a cubic between two parameters, by Gauss-Legendre's rule of three points.
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
        // By Newton's method, or by halves where that leads astray.
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
