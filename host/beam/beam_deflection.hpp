#pragma once

#include "core/beam/beam_profile.hpp"

#include <array>
#include <cstdint>

namespace kfast {

/// How fast a beam reaches its target: each axis by itself, as a mass on a damped spring that is
/// pulled there, and never faster than its top speed.
struct BeamDeflection {
    double bandwidth; ///< natural frequency, in Hz
    double damping;   ///< the damping ratio; 1: the fastest without overshoot
    double top_speed; ///< in widths of the field a second
};

/// The actual position of a beam in the field, in its units.
struct BeamPlace {
    double x = 0;
    double y = 0;
};

/// The moving beam of a vector display. Between two points it goes in steps that are short enough to be
/// taken for straight.
class DeflectedBeam {
public:
    static constexpr int max_steps = 8;

    /// `rate`: points in a second.
    DeflectedBeam(const BeamDeflection& deflection, std::uint32_t rate);

    /// Sets it to a point, at rest.
    void put(FieldPoint at);
    /// Lets it be pulled to `target` for the time of one point. Calls `moved` with the ends of each step, all
    /// of which take equally long.
    template <class Moved>
    void pull(FieldPoint target, Moved moved)
    {
        for (int step = 0; step < steps_; ++step) {
            const BeamPlace from{x_.place, y_.place};
            advance(x_, target.x);
            advance(y_, target.y);
            moved(from, BeamPlace{x_.place, y_.place});
        }
    }
    int steps() const { return steps_; }
    BeamPlace place() const { return {x_.place, y_.place}; }

private:
    struct Axis {
        double place = 0;
        double speed = 0; ///< in units of the field for the time in which the phase of the spring turns by 1
    };
    using Matrix = std::array<double, 4>;

    void advance(Axis& axis, double target) const;

    Axis x_;
    Axis y_;
    int steps_;
    Matrix spring_; ///< the effect of a step on the distance to the target, and on the speed
    double longest_step_;
    double top_speed_;
};

}
