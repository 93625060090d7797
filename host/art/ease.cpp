#include "host/art/ease.hpp"

namespace kfast::art {
namespace {

/// Of a Bézier from 0 to 1.
double cubic(double first, double second, double parameter)
{
    const double rest = 1 - parameter;
    return 3 * rest * rest * parameter * first + 3 * rest * parameter * parameter * second +
           parameter * parameter * parameter;
}

}

double share_of_way(const Ease& ease, double time)
{
    if (time >= 1)
        return 1;
    if (time <= 0 || ease.kind == EaseKind::hold)
        return 0;
    if (ease.kind == EaseKind::linear)
        return time;
    return cubic(ease.y1, ease.y2, parameter_at(ease, time));
}

double parameter_at(const Ease& ease, double time)
{
    // x rises with the parameter, for x1 and x2 are 0 to 1.
    double low = 0;
    double high = 1;
    for (int step = 0; step < 52; ++step) {
        const double middle = (low + high) / 2;
        (cubic(ease.x1, ease.x2, middle) < time ? low : high) = middle;
    }
    return (low + high) / 2;
}

}
