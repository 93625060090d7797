#pragma once

#include "core/time/spring_law.hpp"

#include <string>

namespace kfast {

/// What springs and bounces may be given, such that the progress stays within its range.
namespace spring_limits {
inline constexpr double min_stiffness = 10;
inline constexpr double max_stiffness = 10000;
inline constexpr double min_damping = 4; ///< so that the swing has died down at the next key
inline constexpr double max_damping = 80;
inline constexpr double min_period = 0.1;
inline constexpr double max_period = 1;
}

/// The damping up to which a spring swings, but for the last 0.2 %, where the numbers of an Oscillation end.
double max_damping_of(double stiffness);

/// A mass of 1 on a spring, let go at the earlier key: x" = stiffness (1 - x) - damping x', as if the
/// interval lasted a second. What is left of the way after this second is spread over all of it, so that it
/// ends at the next key. The damping is at most max_damping_of(stiffness).
VelocityLaw mass_on_spring(double stiffness, double damping);

/// A swing that halves ten times and takes `period` of the time: 1 - 2^(-10 u) cos(2 pi u / period), its end
/// corrected likewise.
VelocityLaw elastic_law(double period, SpringEnd end);

/// Of a bounce or a spring, as the scene language writes it: "bounce-in(3)", "spring(100,10)". What is
/// stored of a spring gives its numbers with three digits.
std::string spring_text(const VelocityLaw& law);

}
