#include "host/scene/skeleton/pose_keys.hpp"

#include "core/math/angle.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/bone_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace kfast::scene {
namespace {

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::lround(value)); }

/// The values of a quantity that look the same become the same.
std::int32_t normal(const Bone& bone, BoneQuantity quantity, std::int32_t value)
{
    return goes_the_shortest_way(bone, quantity) ? BinaryAngle::from_raw(value).raw : value;
}

/// `parent_angle` is that on the canvas as set up.
std::array<std::int32_t, bone_quantity_count> values_of(const PosedBone& posed, const Bone& bone,
                                                        double parent_angle)
{
    const auto [angle, x, y, length] = bone.set_up;
    const BoneFrame directions{{}, parent_angle, 0};
    const Vec2 move = directions.inside({posed.x.value_or(0), posed.y.value_or(0)});
    const std::int32_t turned = angle + rounded(posed.turn.value_or(0) * BinaryAngle::turn / 360);
    return {normal(bone, BoneQuantity::angle, turned), x + rounded(move.x * 16), y + rounded(move.y * 16),
            posed.length ? rounded(*posed.length * 16) : length};
}

void warn_of_half_turn(const PosedBone& posed, const Bone& bone, std::int32_t angle, SceneContext& context)
{
    constexpr auto quantity = BoneQuantity::angle;
    const auto& keys = bone.keys[static_cast<std::size_t>(quantity)];
    if (!keys.empty() && goes_the_shortest_way(bone, quantity) &&
        std::abs(angle - keys.back().value) == BinaryAngle::half_turn)
        context.report.warning(posed.place,
                               "from the pose before it is exactly half a turn, which goes counter-clockwise",
                               "turn a little less or more, or say turns=as-written");
}

void add_keys(const Pose& pose, const PosedBone& posed, double parent_angle, Bone& bone,
              SceneContext& context)
{
    bone.driver = pose.driver.driver();
    const auto values = values_of(posed, bone, parent_angle);
    warn_of_half_turn(posed, bone, values.front(), context);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto quantity = static_cast<BoneQuantity>(i);
        const bool has_axis = quantity == BoneQuantity::x || quantity == BoneQuantity::y;
        if (has_axis && !is_bone_origin(values[i])) {
            context.report.error(posed.place, too_far_from_parent());
            return;
        }
        const LawPair laws = has_axis ? pose.laws.of_axes() : pose.laws.of_rest();
        bone.keys[i].push_back({.time = pose.time, .laws = laws, .value = values[i], .place = pose.place});
    }
}

}

std::vector<GivenTurn> add_pose_keys(const std::vector<Pose>& poses, std::vector<Bone>& bones,
                                     SceneContext& context)
{
    const std::vector<BoneFrame> frames = frames_as_set_up(bones);
    std::vector<GivenTurn> turns;
    for (const Pose& pose : poses)
        for (const PosedBone& posed : pose.bones) {
            Bone& bone = bones[posed.bone];
            add_keys(pose, posed, bone.parent ? frames[*bone.parent].angle : 0, bone, context);
            if (posed.turn && pose.driver.is_time())
                turns.push_back({posed.bone, pose.time, posed.place});
        }
    return turns;
}

void tidy_keys(std::vector<Bone>& bones)
{
    for (Bone& bone : bones)
        for (std::size_t i = 0; i < bone.keys.size(); ++i) {
            const auto stays = [&](const TrackKey& key) { return key.value == bone.set_up[i]; };
            if (std::ranges::all_of(bone.keys[i], stays))
                bone.keys[i].clear();
            else
                bone.keys[i].back().laws = {};
        }
}

}
