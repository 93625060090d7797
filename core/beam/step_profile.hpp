#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/pixel/colour.hpp"

#include <cstdint>

namespace kfast {

/// How far a beam goes from point to point, and how long it waits, at some speed level. Four more are twice
/// as fast.
class StepProfile {
public:
    /// As fast as can be: every line is crossed at once.
    static constexpr int max_speed_level = 4 * 31;
    /// Where speed stands for light, darker lines are drawn as if they were as bright as this, so that the
    /// beam is no more than 8 times as fast as along the brightest.
    static constexpr std::uint32_t darkest = 32;
    /// How long a dot is lit besides its dwell, in points, so that it is as bright as a line.
    static constexpr std::uint32_t dot_points = 4;

    /// `profile` must outlive it.
    StepProfile(const BeamProfile& profile, int speed_level) : profile_{&profile}, speed_level_{speed_level}
    {
    }

    /// In units of the field, at least 1.
    std::uint32_t lit_step(Colour colour) const;
    /// Likewise; 0 if the beam jumps.
    std::uint32_t travel_step() const;
    /// What is left of a time in points.
    std::uint32_t dwell(std::uint32_t points) const { return points >> (speed_level_ >> 2); }
    /// At least 1.
    std::uint32_t dot_dwell(Colour colour) const;
    /// Corners are points. In a great hurry they are cut off.
    bool hits_corners() const { return speed_level_ < 4 * 3; }
    const BeamProfile& profile() const { return *profile_; }

private:
    std::uint32_t scaled_step(std::uint32_t step) const;

    const BeamProfile* profile_;
    int speed_level_;
};

}
