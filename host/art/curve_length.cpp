#include "host/art/curve_length.hpp"

namespace kfast::art {
namespace {

using scene::Curve;
using scene::Spot;

constexpr int pieces = 16;

Spot spot_at(Spot from, const Curve& curve, double t)
{
    if (!curve.cubic)
        return (1 - t) * from + t * curve.to;
    const double rest = 1 - t;
    return rest * rest * rest * from + 3 * rest * rest * t * curve.c1 + 3 * rest * t * t * curve.c2 +
           t * t * t * curve.to;
}

double speed(Spot from, const Curve& curve, double t)
{
    const double rest = 1 - t;
    const Spot velocity = 3 * rest * rest * (curve.c1 - from) + 6 * rest * t * (curve.c2 - curve.c1) +
                          3 * t * t * (curve.to - curve.c2);
    return distance(Spot{}, velocity);
}

/// Of a cubic between two parameters, by Gauss-Legendre's rule of three points.
double piece_length(Spot from, const Curve& curve, double begin, double end)
{
    constexpr double offset = 0.774596669241483377; // the square root of 3/5
    const double middle = (begin + end) / 2;
    const double half = (end - begin) / 2;
    return half *
           (5 * speed(from, curve, middle - half * offset) + 8 * speed(from, curve, middle) +
            5 * speed(from, curve, middle + half * offset)) /
           9;
}

double length_until(Spot from, const Curve& curve, double parameter)
{
    double length = 0;
    for (int i = 0; i < pieces; ++i)
        length += piece_length(from, curve, parameter * i / pieces, parameter * (i + 1) / pieces);
    return length;
}

double parameter_at(Spot from, const Curve& curve, double length)
{
    double low = 0;
    double high = 1;
    for (int step = 0; step < 40; ++step) {
        const double middle = (low + high) / 2;
        (length_until(from, curve, middle) < length ? low : high) = middle;
    }
    return high;
}

}

double curve_length(Spot from, const Curve& curve)
{
    return curve.cubic ? length_until(from, curve, 1) : distance(from, curve.to);
}

double outline_length(const scene::Outline& outline)
{
    double length = 0;
    Spot from = outline.from;
    for (const Curve& curve : outline.curves) {
        length += curve_length(from, curve);
        from = curve.to;
    }
    return length;
}

Spot spot_along(const scene::Outline& outline, double share)
{
    double left = share * outline_length(outline);
    Spot from = outline.from;
    if (share <= 0)
        return from;
    for (const Curve& curve : outline.curves) {
        const double length = curve_length(from, curve);
        if (left < length)
            return spot_at(from, curve, curve.cubic ? parameter_at(from, curve, left) : left / length);
        left -= length;
        from = curve.to;
    }
    return from;
}

}
