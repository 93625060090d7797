#include "host/scene_text/bones/rig_text.hpp"

#include "host/program/failure.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/binding.hpp"
#include "host/scene_text/bones/pose_text.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace kfast::scene_text {

namespace {

using art::Bone;
using art::Rig;

/// A node of weights has this name already.
constexpr std::string_view no_bone_name = "points";

void collect_rigs(const std::vector<art::Node>& nodes, std::set<std::size_t>& rigs)
{
    for (const art::Node& node : nodes)
        if (const auto* const group = std::get_if<art::Group>(&node.content))
            collect_rigs(group->nodes, rigs);
        else if (const auto* const shape = std::get_if<art::Shape>(&node.content); shape && shape->skin)
            rigs.insert(shape->skin->rig);
}

bool begins_at_tip(const Bone& bone, const Bone& parent)
{
    return on_grid(bone.from.x, coordinates) == on_grid(parent.to.x, coordinates) &&
           on_grid(bone.from.y, coordinates) == on_grid(parent.to.y, coordinates);
}

class RigText {
public:
    RigText(const Rig& rig, const RigNames& names) : rig_{rig}, names_{names} {}

    kdl::Node write(std::int32_t length) const
    {
        kdl::Node node = named_node("bones", text(names_.rig));
        const Poses poses = poses_of(rig_, names_, length);
        if (poses.turn_as_written)
            set(node, "turns", text("as-written"));
        node.children = children_of(std::nullopt);
        std::ranges::copy(poses.nodes, std::back_inserter(node.children));
        return node;
    }

private:
    std::vector<kdl::Node> children_of(std::optional<std::size_t> parent) const
    {
        std::vector<kdl::Node> nodes;
        for (std::size_t i = 0; i < rig_.bones.size(); ++i)
            if (rig_.bones[i].parent == parent)
                nodes.push_back(bone_node(i));
        return nodes;
    }

    kdl::Node bone_node(std::size_t index) const
    {
        const Bone& bone = rig_.bones[index];
        kdl::Node node = named_node("bone", text(names_.bones[index]));
        for (const double coordinate : {bone.from.x, bone.from.y, bone.to.x, bone.to.y})
            node.arguments.push_back(number(on_grid(coordinate, coordinates), coordinates));
        if (bone.parent && bone.at_tip != begins_at_tip(bone, rig_.bones[*bone.parent]))
            set(node, "tip", truth(bone.at_tip));
        node.children = children_of(index);
        return node;
    }

    const Rig& rig_;
    const RigNames& names_;
};

void take_reach(const Rig& rig, Reach& reach)
{
    reach.left_alone = std::max(reach.left_alone, reach_of(rig));
    reach.in_groups = std::max(reach.in_groups, reach_of(rig));
}

bool exceeds(const art::Channel& channel, const Grid& grid)
{
    return std::ranges::any_of(channel.keys,
                               [&](const auto& key) { return std::abs(key.value) > grid.high; });
}

bool leaves_room(const Bone& bone, const Rig& rig)
{
    const auto keys = bone_keys(bone);
    return std::ranges::any_of(
        keys, [room = room_of(rig, bone)](const BoneKey& key) { return std::hypot(key.x, key.y) > room; });
}

void report_ranges(const Rig& rig, art::Losses& losses)
{
    const auto lose = [&](std::string feature) {
        losses.add({std::move(feature), rig.name, {}, "it is held at that"});
    };
    if (reach_of(rig) > coordinates.high)
        lose("coordinates of bones beyond 2047 px");
    else if (std::ranges::any_of(rig.bones, [&](const Bone& bone) { return leaves_room(bone, rig); }))
        lose("a bone that begins more than 2047 px from its parent's origin");
    if (std::ranges::any_of(rig.bones, [](const Bone& bone) { return exceeds(bone.rotation, turns); }))
        lose("a bone that turns more than 15 times");
    if (std::ranges::any_of(rig.bones,
                            [](const Bone& bone) { return bone.length && exceeds(*bone.length, widths); }))
        lose("a bone longer than 4095 px");
}

void check_limits(const art::Document& document, const std::set<std::size_t>& rigs)
{
    std::size_t bones = 0;
    for (const std::size_t rig : rigs) {
        bones += document.rigs[rig].bones.size();
        if (document.rigs[rig].bones.size() > scene::max_bones)
            throw Failure("a skeleton has more than " + std::to_string(scene::max_bones) +
                          " bones, the most in a scene; join some of them");
    }
    if (bones > scene::max_bones_together || rigs.size() > scene::max_skeletons)
        throw Failure(
            "there are more skeletons or bones than a scene holds: " + std::to_string(scene::max_skeletons) +
            " and " + std::to_string(scene::max_bones_together) + " together; leave out some of them");
}

}

std::vector<RigNames> rig_names(const std::vector<Rig>& rigs)
{
    std::vector<RigNames> result;
    Names names;
    for (const Rig& rig : rigs) {
        RigNames own{names.unique(rig.name, "bones"), {}};
        Names bones;
        bones.reserve(no_bone_name);
        for (const Bone& bone : rig.bones)
            own.bones.push_back(bones.unique(bone.name, "bone"));
        result.push_back(std::move(own));
    }
    return result;
}

std::vector<kdl::Node> rig_nodes(const art::Document& document, const Writing& writing, Reach& reach)
{
    std::set<std::size_t> rigs;
    collect_rigs(document.nodes, rigs);
    check_limits(document, rigs);
    std::vector<kdl::Node> nodes;
    for (const std::size_t rig : rigs) {
        take_reach(document.rigs[rig], reach);
        report_ranges(document.rigs[rig], writing.losses);
        nodes.push_back(RigText{document.rigs[rig], writing.rigs[rig]}.write(writing.length));
    }
    return nodes;
}

namespace {

constexpr Grid fine_weights{4096, 1, 0, 1000};

scene::Binding binding_of(const std::vector<art::BoneInfluence>& shares)
{
    std::vector<scene::WeightedBone> bones;
    bones.reserve(shares.size());
    for (const art::BoneInfluence& share : shares)
        bones.push_back({share.bone, share.weight});
    return scene::bound(std::move(bones));
}

bool same(const scene::Binding& one, const scene::Binding& other)
{
    return std::ranges::equal(one, other, [](const scene::BoneWeight& left, const scene::BoneWeight& right) {
        return left.bone == right.bone && left.weight == right.weight;
    });
}

std::vector<kdl::Node> weight_nodes(const scene::Binding& binding, const RigNames& names)
{
    std::vector<kdl::Node> nodes;
    for (const scene::BoneWeight& bone : binding)
        nodes.push_back(named_node(
            names.bones[bone.bone],
            number(on_grid(bone.weight / double{kfb::skin::whole_weight}, fine_weights), fine_weights)));
    return nodes;
}

kdl::Node points_node(std::size_t first, std::size_t last, const scene::Binding& binding,
                      const RigNames& names)
{
    kdl::Node points = named_node("points", number(first));
    if (last != first)
        points.arguments.push_back(number(last));
    points.children = weight_nodes(binding, names);
    return points;
}

}

void add_skin(kdl::Node& object, const art::Skin& skin, const RigNames& names)
{
    set(object, "skin", text(names.rig));
    std::vector<scene::Binding> bindings;
    for (const auto& point : skin.points)
        bindings.push_back(binding_of(point));
    const bool all_same =
        std::ranges::all_of(bindings, [&](const auto& one) { return same(one, bindings.front()); });
    if (all_same && bindings.front().size() == 1)
        set(object, "bone", text(names.bones[bindings.front().front().bone]));
    if (skin.turns_changes)
        set(object, "change", text("bones"));
    if (all_same && bindings.front().size() == 1)
        return;
    kdl::Node carried = named_node("weights");
    if (all_same)
        carried.children = weight_nodes(bindings.front(), names);
    for (std::size_t first = 0; !all_same && first < bindings.size();) {
        std::size_t last = first;
        while (last + 1 < bindings.size() && same(bindings[first], bindings[last + 1]))
            ++last;
        carried.children.push_back(points_node(first + 1, last + 1, bindings[first], names));
        first = last + 1;
    }
    object.children.push_back(std::move(carried));
}

}
