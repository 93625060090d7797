#include "host/beam/beam_deflection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast {
namespace {

using Matrix = std::array<double, 4>;

Matrix product(const Matrix& a, const Matrix& b)
{
    return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
            a[2] * b[1] + a[3] * b[3]};
}

/// e^(rates * phase), by its series: phases of a step are small.
Matrix exponential(const Matrix& rates, double phase)
{
    constexpr int terms = 40;
    Matrix sum{1, 0, 0, 1};
    Matrix term = sum;
    for (int n = 1; n < terms; ++n) {
        term = product(term, rates);
        for (std::size_t i = 0; i < term.size(); ++i) {
            term[i] *= phase / n;
            sum[i] += term[i];
        }
    }
    return sum;
}

/// The phase of a spring changes by at most this in a step, if that makes no more than max_steps.
constexpr double longest_phase = 0.25;

}

DeflectedBeam::DeflectedBeam(const BeamDeflection& deflection, std::uint32_t rate)
{
    const double angular = 2 * std::numbers::pi * deflection.bandwidth;
    const double phase = angular / rate;
    steps_ = std::clamp(static_cast<int>(std::ceil(phase / longest_phase)), 1, max_steps);
    spring_ = exponential({0, 1, -1, -2 * deflection.damping}, phase / steps_);
    longest_step_ = deflection.top_speed * field_side / rate / steps_;
    top_speed_ = deflection.top_speed * field_side / angular;
}

void DeflectedBeam::put(FieldPoint at)
{
    x_ = {static_cast<double>(at.x), 0};
    y_ = {static_cast<double>(at.y), 0};
}

void DeflectedBeam::advance(Axis& axis, double target) const
{
    const double distance = axis.place - target;
    const double wanted = target + spring_[0] * distance + spring_[1] * axis.speed;
    const double speed = spring_[2] * distance + spring_[3] * axis.speed;
    axis.place += std::clamp(wanted - axis.place, -longest_step_, longest_step_);
    axis.speed = std::clamp(speed, -top_speed_, top_speed_);
}

}
