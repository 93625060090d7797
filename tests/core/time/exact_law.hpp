#pragma once

#include "core/time/velocity_law.hpp"

#include <cmath>
#include <numbers>

namespace kfast::test {

/// The share of the way at a share of the time, by the formula of the law; not of a bezier.
inline double exact_progress(const VelocityLaw& law, double time)
{
    using std::numbers::pi;
    switch (law.kind) {
    case VelocityLaw::Kind::accelerate:
        return 1 - std::cos(pi * time / 2);
    case VelocityLaw::Kind::decelerate:
        return std::sin(pi * time / 2);
    case VelocityLaw::Kind::accelerate_decelerate:
        return (1 - std::cos(pi * time)) / 2;
    case VelocityLaw::Kind::hold:
        return time < 1 ? 0 : 1;
    default:
        return time;
    }
}

}
