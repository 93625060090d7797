#include "host/scene/skeleton/bones_reader.hpp"

#include "core/math/angle.hpp"
#include "host/geometry/drawing.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/skeleton/bone_frames.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/skeleton/pose_keys.hpp"
#include "host/scene/skeleton/pose_reader.hpp"
#include "host/scene/skeleton/reach_keys.hpp"
#include "host/scene/skeleton/reach_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace kfast::scene {

namespace {

using Written = std::vector<WrittenBone>;

/// Roots first, then their children, then theirs; without those that are their own ancestors.
std::vector<std::size_t> level_order(const Written& bones)
{
    std::vector<std::size_t> order;
    const auto add_children = [&](std::optional<std::size_t> parent) {
        for (std::size_t i = 0; i < bones.size(); ++i)
            if (bones[i].parent == parent)
                order.push_back(i);
    };
    add_children(std::nullopt);
    for (std::size_t i = 0; i < order.size(); ++i)
        add_children(order[i]);
    return order;
}

/// From `bone` up until it recurs; nothing if it does not.
std::vector<std::size_t> cycle_of(const Written& bones, std::size_t bone)
{
    std::vector<std::size_t> cycle;
    for (std::size_t at = bone; cycle.size() <= bones.size(); at = *bones[at].parent) {
        if (!cycle.empty() && at == bone)
            return cycle;
        cycle.push_back(at);
    }
    return {};
}

/// Reported once for each cycle, at the first of its bones.
void report_cycles(const Written& bones, const std::vector<std::size_t>& order, SceneContext& context)
{
    for (std::size_t i = 0; i < bones.size(); ++i) {
        if (std::ranges::find(order, i) != order.end())
            continue;
        const std::vector<std::size_t> cycle = cycle_of(bones, i);
        if (cycle.empty() || std::ranges::min(cycle) != i)
            continue;
        std::string chain;
        for (const std::size_t bone : cycle)
            chain += visible(bones[bone].name) + " → ";
        context.report.error(property_span(*bones[i].node, "parent"),
                             "the bone " + in_quotes(bones[i].name) + " hangs on itself, and on no root",
                             chain + visible(bones[i].name) + "; let one of them have no parent");
    }
}

bool same_place(Vec2 a, Vec2 b)
{
    return to_sixteenths(a.x) == to_sixteenths(b.x) && to_sixteenths(a.y) == to_sixteenths(b.y);
}

double direction_between(Vec2 from, Vec2 to)
{
    return std::atan2(to.y - from.y, to.x - from.x) * BinaryAngle::turn / (2 * std::numbers::pi);
}

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::lround(value)); }

/// In the frame of the parent as it is stored, so that what is lost by rounding does not add up.
Bone set_up(const WrittenBone& written, const BoneFrame& parent)
{
    const double angle = direction_between(written.from, written.to) - parent.angle;
    const Vec2 origin = parent.inside(written.from);
    Bone bone;
    bone.name = written.name;
    bone.set_up = {BinaryAngle::from_raw(rounded(angle)).raw, rounded(origin.x * 16), rounded(origin.y * 16),
                   rounded(distance(written.from, written.to) * 16)};
    bone.place = written.place;
    return bone;
}

bool check(const Bone& bone, SceneContext& context)
{
    const auto [angle, x, y, length] = bone.set_up;
    if (length == 0)
        return context.report.error(bone.place, "this bone has no length",
                                    "let it end elsewhere than it begins");
    if (length > longest_bone)
        return context.report.error(bone.place,
                                    "this bone is longer than " + std::to_string(longest_bone / 16) + " px");
    return (is_bone_origin(x) && is_bone_origin(y)) ||
           context.report.error(bone.place, too_far_from_parent(), "put a bone between them");
}

/// Puts bones into level order, each into the frame of its parent. Bones that are their own ancestors, and
/// all their descendants, are reported and left out, as is what the format cannot hold; then `skeleton` is no
/// longer valid.
void set_up_bones(const Written& written, Skeleton& skeleton, SceneContext& context)
{
    const std::vector<std::size_t> order = level_order(written);
    std::vector<Bone>& bones = skeleton.bones.bones;
    std::vector<BoneFrame> frames;
    for (const std::size_t index : order) {
        const WrittenBone& own = written[index];
        const auto parent =
            own.parent ? std::optional{std::ranges::find(order, *own.parent) - order.begin()} : std::nullopt;
        const BoneFrame around = parent ? frames[static_cast<std::size_t>(*parent)] : BoneFrame{};
        Bone& bone = bones.emplace_back(set_up(own, around));
        if (parent) {
            bone.parent = static_cast<std::size_t>(*parent);
            bone.is_at_tip = own.tip.value_or(same_place(own.from, written[*own.parent].to));
        }
        frames.push_back(frame_in(around, bone, values_as_set_up(bone), 0));
        skeleton.regions.push_back(own.region.value_or(distance(own.from, own.to) / 2));
        if (own.is_valid)
            skeleton.is_valid = check(bone, context) && skeleton.is_valid;
    }
    if (order.size() == written.size())
        return;
    report_cycles(written, order, context);
    skeleton.is_valid = false;
}

constexpr NodeForm bones_form{bones_name, "bones NAME { bone NAME X Y X Y }", 1, 1, true};

constexpr std::array known_nodes{bone_name, pose_name, reach_name};

struct BonesProperties {
    bool turns_as_written = false;
};

constexpr std::array turn_words{Word<bool>{"shortest", false}, Word<bool>{"as-written", true}};

bool read_turns(const kdl::Value& value, BonesProperties& bones, SceneContext& context)
{
    return assign(read_word(value, turn_words, context.report), bones.turns_as_written);
}

constexpr std::array bones_rules{
    PropertyRule<BonesProperties>{"turns", read_turns, ValueKind::one_of<turn_words>()}};

void refuse_unknown_nodes(const kdl::Node& node, SceneContext& context)
{
    for (const kdl::Node& child : node.children)
        if (std::ranges::find(known_nodes, child.name) == known_nodes.end() && !context.report.full())
            context.report.error(child.name_span, "a skeleton has no node " + in_quotes(child.name),
                                 word_hint(child.name, known_nodes));
}

bool has_capacity(const Skeleton& skeleton, SceneContext& context)
{
    if (context.skeletons.entries.size() == max_skeletons)
        return context.report.error(skeleton.bones.place,
                                    "a scene has at most " + std::to_string(max_skeletons) + " skeletons");
    return context.skeletons.bone_count() + skeleton.bones.bones.size() <= max_bones_together ||
           context.report.error(skeleton.bones.place, "the skeletons of a scene have at most " +
                                                          std::to_string(max_bones_together) +
                                                          " bones together");
}

void read_bones(const kdl::Node& node, Skeleton& skeleton, SceneContext& context)
{
    BoneReader reader{context};
    for (const kdl::Node& child : node.children)
        if (child.name == bone_name)
            reader.read(child);
    const std::vector<WrittenBone> written = reader.take();
    skeleton.is_valid = reader.is_valid();
    if (written.empty() && skeleton.is_valid)
        skeleton.is_valid = context.report.error(skeleton.bones.place, "this skeleton has no bones",
                                                 "add { bone NAME X Y X Y }");
    set_up_bones(written, skeleton, context);
}

void read_movement(const kdl::Node& node, std::vector<Bone>& bones, SceneContext& context)
{
    PoseReader poses{bones, context};
    std::vector<Reach> reaches;
    for (const kdl::Node& child : node.children) {
        if (context.report.full())
            return;
        if (child.name == pose_name)
            poses.read(child);
        else if (child.name == reach_name)
            if (auto reach = read_reach(child, bones, context))
                reaches.push_back(std::move(*reach));
    }
    const std::vector<GivenTurn> turns = add_pose_keys(poses.take(), bones, context);
    add_reach_keys(std::move(reaches), turns, bones, context);
    tidy_keys(bones);
}

}

void add_skeleton(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, bones_form, context.report))
        return;
    Skeleton skeleton;
    skeleton.bones.place = span(node.name_span, node.arguments.front().place);
    BonesProperties properties;
    read_properties(node, bones_rules, properties, context);
    refuse_unknown_nodes(node, context);
    read_bones(node, skeleton, context);
    for (Bone& bone : skeleton.bones.bones)
        bone.turns_as_written = properties.turns_as_written;
    // Where bones are missing, all references to them would be errors as well.
    if (skeleton.is_valid)
        read_movement(node, skeleton.bones.bones, context);
    const auto name = read_name(node.arguments.front(), context.report);
    if (!name || !has_capacity(skeleton, context))
        return;
    skeleton.bones.name = *name;
    if (const auto earlier = context.skeletons.find(*name))
        report_duplicate("a skeleton", *name, skeleton.bones.place,
                         context.skeletons.entries[*earlier].bones.place, context.report);
    else
        context.skeletons.entries.push_back(std::move(skeleton));
}

void warn_of_unused_skeletons(SceneContext& context)
{
    for (const Skeleton& skeleton : context.skeletons.entries)
        if (!skeleton.is_used)
            context.report.warning(
                skeleton.bones.place, "the skeleton " + in_quotes(skeleton.bones.name) + " carries nothing",
                "add skin=" + visible(skeleton.bones.name) + " to an object, or remove it");
}

NodeSchema bones_schema()
{
    return {
        bones_name, bones_form, {any_name}, schema_of(bones_rules), {known_nodes.begin(), known_nodes.end()}};
}

}
