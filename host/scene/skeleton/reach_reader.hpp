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

/// On which side the joint lies of the line from the chain's origin to the target, as seen along it.
enum class Bend : std::uint8_t { left, right };

/// Where the tip is to be; the law governs the way to the next target, which is straight.
struct ReachTarget {
    Time time;
    Vec2 spot;
    VelocityLaw law;
    SourceSpan place;
};

/// A bone and its parent turn so that the tip of the bone follows a target.
struct Reach {
    std::size_t bone = 0; ///< has a parent, and begins at its tip
    Bend bend = Bend::left;
    std::vector<ReachTarget> targets; ///< at least one; their times rise
    SourceSpan place;

    Time begin() const { return targets.front().time; }
    Time end() const { return targets.back().time; }
};

/// Where the target is at a time between begin() and end().
Vec2 target_at(const Reach& reach, Time time);

/// Nothing when the node gives no usable reach; what is wrong is reported.
std::optional<Reach> read_reach(const kdl::Node& node, const std::vector<Bone>& bones, SceneContext& context);

/// Of a reach, and of its targets.
std::vector<NodeSchema> reach_words();

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
