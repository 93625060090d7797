#pragma once

#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/bone_frames.hpp"
#include "host/schema/node_form.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

inline constexpr std::string_view reach_name = "reach";

/// On which side of the line from the chain's origin to the target the joint is, as seen along it.
enum class Bend : std::uint8_t { left, right };

/// Where the tip is to be; the law governs the motion to the next target, which is straight.
struct ReachTarget {
    Time time;
    Vec2 spot;
    VelocityLaw law;
    SourceSpan place;
};

/// A bone and its parent rotate so that the tip of the bone follows a target.
struct Reach {
    std::size_t bone = 0; ///< has a parent, and begins at its tip
    Bend bend = Bend::left;
    std::vector<ReachTarget> targets; ///< at least one; their times rise
    SourceSpan place;

    Time begin() const { return targets.front().time; }
    Time end() const { return targets.back().time; }
};

/// The position of the target at a time between begin() and end().
Vec2 target_at(const Reach& reach, Time time);

/// Nothing when the node is no usable reach; what is wrong is reported.
std::optional<Reach> read_reach(const kdl::Node& node, const std::vector<Bone>& bones, SceneContext& context);

/// The schema of a reach, and of its targets.
std::vector<NodeSchema> reach_schema();

/// A bone and its parent at a time, without their angles.
struct Arm {
    BoneFrame base; ///< the frame that the upper bone rotates in, its origin moved to that of the bone
    Vec2 joint;     ///< in the frame of the upper bone
    double lower_length = 0;

    Vec2 tip(double upper, double lower) const;
};

/// The arm that ends in `bone`, whose own angle and that of its parent are ignored.
Arm arm_at(const std::vector<Bone>& bones, std::size_t bone, Time time);

/// Each angle is in the frame of its parent, in 1/65536 turn.
struct ArmAngles {
    double upper = 0;
    double lower = 0;
};

/// The angles that bring the tip to `target`, or as near to it as possible.
ArmAngles angles_reaching(const Arm& arm, Vec2 target, Bend bend);

}
