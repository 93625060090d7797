#pragma once

#include "host/scene/skeleton/bone_frames.hpp"
#include "host/scene/skeleton/reach_reader.hpp"

namespace kfast::scene {

/// A bone and its parent at a moment, but for how they are turned.
struct Arm {
    BoneFrame base; ///< what the upper bone turns in, its origin moved to that of the upper bone
    Vec2 joint;     ///< in the frame of the upper bone
    double lower_length = 0;

    Vec2 tip(double upper, double lower) const;
};

/// The arm that ends in `bone`, whose own angle and that of its parent are not looked at.
Arm arm_at(const std::vector<Bone>& bones, std::size_t bone, Time time);

/// Each in the frame of its parent, in 1/65536 turn.
struct ArmAngles {
    double upper = 0;
    double lower = 0;
};

/// That bring the tip to `target`, or as near to it as can be.
ArmAngles angles_reaching(const Arm& arm, Vec2 target, Bend bend);

}
