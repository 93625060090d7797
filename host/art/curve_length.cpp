#include "host/art/curve_length.hpp"

#include <algorithm>

namespace kfast::art {
namespace {

using scene::Curve;
using scene::Spot;

Spot between(Spot a, Spot b, double share) { return a + share * (b - a); }

/// The polar form of a cubic Bézier: its control points over other stretches are values of it.
Spot blossom(Spot from, const Curve& curve, double r, double s, double t)
{
    const Spot first = between(from, curve.c1, r);
    const Spot second = between(curve.c1, curve.c2, r);
    const Spot third = between(curve.c2, curve.to, r);
    return between(between(first, second, s), between(second, third, s), t);
}

}

Spot spot_at(Spot from, const Curve& curve, double parameter)
{
    return curve.cubic ? blossom(from, curve, parameter, parameter, parameter)
                       : between(from, curve.to, parameter);
}

CurvePiece piece(Spot from, const Curve& curve, double begin, double end)
{
    if (!curve.cubic)
        return {between(from, curve.to, begin), scene::line_to(between(from, curve.to, end))};
    return {spot_at(from, curve, begin),
            scene::cubic_to(blossom(from, curve, begin, begin, end), blossom(from, curve, begin, end, end),
                            spot_at(from, curve, end))};
}

CurveLength::CurveLength(Spot from, const Curve& curve)
{
    Spot last = from;
    for (std::size_t i = 1; i <= steps; ++i) {
        const Spot next = spot_at(from, curve, static_cast<double>(i) / steps);
        lengths_[i] = lengths_[i - 1] + scene::distance(last, next);
        last = next;
    }
}

double CurveLength::parameter_at(double length) const
{
    const auto next = std::ranges::upper_bound(lengths_, length);
    if (next == lengths_.begin())
        return 0;
    if (next == lengths_.end())
        return 1;
    const double before = *(next - 1);
    return (static_cast<double>(next - lengths_.begin() - 1) + (length - before) / (*next - before)) / steps;
}

}
