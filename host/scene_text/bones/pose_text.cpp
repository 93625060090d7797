#include "host/scene_text/bones/pose_text.hpp"

#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/reach.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace kfast::scene_text {

namespace {

using art::Bone;
using art::Channel;

/// Pieces per frame of a transition that no law represents.
constexpr double pieces_per_frame = 2;
constexpr double max_pieces = 64;

enum Quantity : std::size_t { rotation, x, y, length, quantity_count };
using Quantities = std::array<Channel, quantity_count>;

std::vector<double> times_of(const Quantities& quantities)
{
    std::vector<double> times;
    for (const Channel& channel : quantities)
        for (const auto& key : with_laws(channel))
            times.push_back(key.time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// The single law of the transition; nothing if there is none.
std::optional<std::string> law_between(const Channel& channel, double from, double to, bool& is_one)
{
    const auto next = std::ranges::upper_bound(channel.keys, from, {}, &art::Key<double>::time);
    if (next == channel.keys.begin() || next == channel.keys.end() || channel.at(from) == channel.at(to))
        return std::nullopt;
    const auto& key = *std::prev(next);
    const double span = next->time - key.time;
    const auto parts = art::ease_parts(key.ease, (from - key.time) / span, (to - key.time) / span);
    is_one = is_one && parts.size() == 1;
    return law_of(parts.front().ease);
}

/// The common law of both in a transition, if there is one.
std::optional<std::string> common_law(const std::optional<std::string>& one,
                                      const std::optional<std::string>& other, bool& is_one)
{
    is_one = is_one && (!one || !other || *one == *other);
    return one ? one : other;
}

class BoneWays {
public:
    explicit BoneWays(const Bone& bone)
        : quantities_{bone.rotation, bone.x, bone.y,
                      bone.length.value_or(Channel{scene::distance(bone.from, bone.to)})}
    {
    }

    std::vector<BoneKey> keys() &&
    {
        const std::vector<double> times = times_of(quantities_);
        for (std::size_t i = 0; i < times.size(); ++i)
            if (i + 1 < times.size())
                add_way(times[i], times[i + 1]);
            else
                add(times[i], {}, {});
        return std::move(keys_);
    }

private:
    void add_way(double from, double to)
    {
        bool is_one = true;
        const auto law_of_quantity = [&](Quantity quantity) {
            return law_between(quantities_[quantity], from, to, is_one);
        };
        const auto law = common_law(law_of_quantity(rotation), law_of_quantity(length), is_one);
        const auto place_law = common_law(law_of_quantity(x), law_of_quantity(y), is_one);
        if (is_one)
            return add(from, law, place_law);
        const double pieces = std::clamp(std::ceil((to - from) * pieces_per_frame), 2.0, max_pieces);
        for (double piece = 0; piece < pieces; ++piece)
            add(art::mixed(from, to, piece / pieces), "constant", "constant");
    }

    void add(double time, std::optional<std::string> law, std::optional<std::string> place_law)
    {
        keys_.push_back({time, quantities_[rotation].at(time), quantities_[x].at(time),
                         quantities_[y].at(time), quantities_[length].at(time), std::move(law),
                         std::move(place_law)});
    }

    Quantities quantities_;
    std::vector<BoneKey> keys_ = {};
};

bool is_zero(const Channel& channel) { return channel.is_still() && channel.value() == 0; }

scene::Vec2 stored(scene::Vec2 spot) { return {snapped(spot.x, coordinates), snapped(spot.y, coordinates)}; }

}

/// As the ends of a bone are rounded, it may be set up one step longer or shorter than it is.
bool changes_length(const Bone& bone)
{
    if (!bone.length)
        return false;
    const double set_up = scene::distance(stored(bone.from), stored(bone.to));
    return !bone.length->is_still() ||
           std::abs(on_grid(bone.length->value(), widths) - on_grid(set_up, widths)) > 1;
}

std::vector<BoneKey> bone_keys(const Bone& bone)
{
    if (is_zero(bone.rotation) && is_zero(bone.x) && is_zero(bone.y) && !changes_length(bone))
        return {};
    return BoneWays{bone}.keys();
}

namespace {

/// The largest angle for which the shorter way round is certain, in degrees.
constexpr double widest_turn = 179;

/// Bones that leave a time by the same laws.
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
