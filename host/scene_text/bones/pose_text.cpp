#include "host/scene_text/bones/pose_text.hpp"

#include "host/scene_text/bones/bone_keys.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/reach.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace kfast::scene_text {
namespace {

/// What the shortest way is sure of, in degrees.
constexpr double widest_turn = 179;

/// Bones that leave a moment by the same laws.
struct Pose {
    std::optional<std::string> law;
    std::optional<std::string> place_law;
    std::vector<kdl::Node> bones;
};

bool agree(const std::optional<std::string>& one, const std::optional<std::string>& other)
{
    return !one || !other || *one == *other;
}

class PoseText {
public:
    PoseText(const art::Rig& rig, const RigNames& names)
    {
        for (std::size_t i = 0; i < rig.bones.size(); ++i)
            add(rig.bones[i], names.bones[i], room_of(rig, rig.bones[i]));
    }

    Poses write(std::int32_t length) const
    {
        Poses poses{{}, turns_wide_};
        std::int32_t last = -1;
        for (const auto& [ticks, moment] : moments_)
            for (const Pose& pose : moment) {
                last = std::max(ticks, last + 1);
                if (last <= length)
                    poses.nodes.push_back(node_of(last, pose));
            }
        return poses;
    }

private:
    void add(const art::Bone& bone, const std::string& name, double room)
    {
        std::vector<BoneKey> keys = bone_keys(bone);
        for (BoneKey& key : keys)
            hold(key, room);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            place(keys[i], bone_node(bone, name, keys[i]));
            if (i > 0 && std::abs(keys[i].rotation - keys[i - 1].rotation) > widest_turn)
                turns_wide_ = true;
        }
    }

    static void hold(BoneKey& key, double room)
    {
        const double away = std::hypot(key.x, key.y);
        if (away <= room)
            return;
        key.x *= room / away;
        key.y *= room / away;
    }

    void place(const BoneKey& key, kdl::Node bone)
    {
        std::vector<Pose>& moment = moments_[on_grid(key.time, times)];
        const auto fits = [&](const Pose& pose) {
            return agree(pose.law, key.law) && agree(pose.place_law, key.place_law) &&
                   std::ranges::find(pose.bones, bone.name, &kdl::Node::name) == pose.bones.end();
        };
        auto pose = std::ranges::find_if(moment, fits);
        if (pose == moment.end())
            pose = moment.insert(moment.end(), Pose{});
        if (key.law)
            pose->law = key.law;
        if (key.place_law)
            pose->place_law = key.place_law;
        pose->bones.push_back(std::move(bone));
    }

    static void add_number(kdl::Node& node, std::string_view property, double value, const Grid& grid)
    {
        if (const std::int32_t stored = on_grid(value, grid); stored != 0)
            set(node, property, number(stored, grid));
    }

    static kdl::Node bone_node(const art::Bone& bone, const std::string& name, const BoneKey& key)
    {
        kdl::Node node = named_node(name);
        add_number(node, "turn", key.rotation, turns);
        add_number(node, "x", key.x, coordinates);
        add_number(node, "y", key.y, coordinates);
        if (changes_length(bone))
            set(node, "length", number(on_grid(key.length, widths), widths));
        return node;
    }

    static kdl::Node node_of(std::int32_t ticks, const Pose& pose)
    {
        kdl::Node node = named_node("pose", number(ticks, times));
        const std::string law = pose.law.value_or(pose.place_law.value_or("constant"));
        if (law != "constant")
            set(node, "law", text(law));
        if (pose.place_law && *pose.place_law != law)
            for (const std::string_view axis : {"law-x", "law-y"})
                set(node, axis, text(*pose.place_law));
        node.children = pose.bones;
        return node;
    }

    std::map<std::int32_t, std::vector<Pose>> moments_ = {};
    bool turns_wide_ = false;
};

}

Poses poses_of(const art::Rig& rig, const RigNames& names, std::int32_t length)
{
    return PoseText{rig, names}.write(length);
}

}
