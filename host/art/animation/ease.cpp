#include "host/art/animation/ease.hpp"

#include <cmath>

namespace kfast::art {
namespace {

/// Of a Bézier from 0 to 1.
double cubic(double first, double second, double parameter)
{
    const double rest = 1 - parameter;
    return 3 * rest * rest * parameter * first + 3 * rest * parameter * parameter * second +
           parameter * parameter * parameter;
}

double slope(double first, double second, double parameter)
{
    const double rest = 1 - parameter;
    return 3 * (rest * rest * first + 2 * rest * parameter * (second - first) +
                parameter * parameter * (1 - second));
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
    // x rises with the parameter, for x1 and x2 are 0 to 1. Newton's steps, or halves where those lead away.
    constexpr int max_steps = 60;
    constexpr double near_enough = 1e-15;
    double low = 0;
    double high = 1;
    double parameter = time;
    for (int step = 0; step < max_steps; ++step) {
        const double miss = cubic(ease.x1, ease.x2, parameter) - time;
        if (std::abs(miss) <= near_enough)
            break;
        (miss < 0 ? low : high) = parameter;
        const double next = parameter - miss / slope(ease.x1, ease.x2, parameter);
        parameter = low < next && next < high ? next : (low + high) / 2;
    }
    return parameter;
}

}
