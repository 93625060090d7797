#include "host/scene/skeleton/pose_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm timed_form{pose_name, "pose TIME NAME law=LAW { BONE turn=DEGREES }", 1, 2, true};
constexpr NodeForm definition_form{pose_name, "pose NAME { BONE turn=DEGREES }", 1, 1, true};

/// All bones as they are set up.
constexpr std::string_view rest_name = "rest";

/// Fifteen turns: plus the angle as set up, this stays within what the format holds.
constexpr Range turns{-5400, 5400};
constexpr int longest_in_pixels = longest_bone / 16;
constexpr Range lengths{0, longest_in_pixels};

template <std::optional<double> PosedBone::*quantity, const Range& range>
bool read_quantity(const kdl::Value& value, PosedBone& bone, SceneContext& context)
{
    return assign(read_number(value, range, context.report), bone.*quantity);
}

constexpr std::array bone_rules{
    PropertyRule<PosedBone>{"turn", read_quantity<&PosedBone::turn, turns>, ValueKind::degrees(turns)},
    PropertyRule<PosedBone>{"x", read_quantity<&PosedBone::x, coordinates>, ValueKind::pixels(coordinates)},
    PropertyRule<PosedBone>{"y", read_quantity<&PosedBone::y, coordinates>, ValueKind::pixels(coordinates)},
    PropertyRule<PosedBone>{"length", read_quantity<&PosedBone::length, lengths>, ValueKind::pixels(lengths)},
};

/// `name` is that of a bone.
NodeForm bone_form(std::string_view name) { return {name, "BONE turn=DEGREES x=X y=Y length=LENGTH"}; }

std::vector<PosedBone> all_as_set_up(std::size_t count, SourceSpan place)
{
    std::vector<PosedBone> bones(count);
    for (std::size_t i = 0; i < count; ++i) {
        bones[i].bone = i;
        bones[i].place = place;
    }
    return bones;
}

constexpr auto pose_rules =
    joined(law_rules<Pose>, std::array{PropertyRule<Pose>{"input", read_own_driver<Pose>, any_name}});

/// A text may be a time as well, if it is an expression: then it has a name behind it, a unit or a =.
bool begins_with_name(const kdl::Node& pose)
{
    const kdl::Value& first = pose.arguments.front();
    const bool has_name_behind = pose.arguments.size() > 1 && pose.arguments.back().string() != nullptr;
    return first.string() != nullptr && !has_name_behind && !first.type && !first.string()->starts_with('=');
}

bool shares_a_bone(const Pose& pose, const std::vector<bool>& bones)
{
    return std::ranges::any_of(pose.bones, [&](const PosedBone& posed) { return bones[posed.bone]; });
}

}

void PoseReader::read(const kdl::Node& node)
{
    if (!fits(node, timed_form, context_.report))
        return;
    if (begins_with_name(node))
        read_definition(node);
    else
        read_timed(node);
}

void PoseReader::read_definition(const kdl::Node& node)
{
    if (!fits(node, definition_form, context_.report) || !refuse_properties(node, context_.report))
        return;
    const kdl::Value& name = node.arguments.front();
    const SourceSpan place = span(node.name_span, name.place);
    if (node.children.empty())
        context_.report.error(place, "this pose has neither a time nor bones",
                              "write pose TIME " + visible(*name.string()) +
                                  ", or add { BONE turn=DEGREES }");
    else
        define(name, place, read_bones(node), false);
}

void PoseReader::read_timed(const kdl::Node& node)
{
    const kdl::Value& moment = node.arguments.front();
    Pose pose;
    pose.node = &node;
    pose.place = span(node.name_span, moment.place);
    read_properties(node, pose_rules, pose, context_);
    const kdl::Value* const name = node.arguments.size() > 1 ? &node.arguments.back() : nullptr;
    if (!node.children.empty())
        set(pose, read_bones(node));
    if (!node.children.empty() && name != nullptr)
        define(*name, pose.place, pose.bones, true);
    if (node.children.empty() && name == nullptr)
        context_.report.error(pose.place, "this pose sets no bones",
                              "add { BONE turn=DEGREES }, or the name of a pose such as rest");
    const auto time = pose.driver.read_moment(moment, context_);
    pose.time = time.value_or(Time{});
    if (!time || !in_order(pose))
        return;
    if (node.children.empty() && name != nullptr)
        mentions_.push_back({poses_.size(), name});
    poses_.push_back(std::move(pose));
}

bool PoseReader::in_order(const Pose& pose)
{
    if (poses_.size() == max_keys)
        return context_.report.error(pose.place, "at most " + std::to_string(max_keys) + " poses stand here");
    const auto goes_alike = [&pose](const Pose& other) {
        return other.driver.driver() == pose.driver.driver();
    };
    const auto before = std::find_if(poses_.rbegin(), poses_.rend(), goes_alike);
    return before == poses_.rend() || comes_later(pose_name, {before->time, before->place},
                                                  {pose.time, pose.place}, pose.driver, context_);
}

void PoseReader::define(const kdl::Value& name, SourceSpan place, const std::vector<PosedBone>& bones,
                        bool is_used)
{
    const auto text = read_name(name, context_.report);
    if (!text)
        return;
    if (*text == rest_name)
        context_.report.error(name.place, "\"rest\" is the pose of all bones as they are set up",
                              "choose another name");
    else if (add_name(names_, "a pose", *text, place, context_.report))
        definitions_.push_back({std::string{*text}, place, bones, is_used});
}

std::vector<PosedBone> PoseReader::read_bones(const kdl::Node& node)
{
    std::vector<PosedBone> bones;
    for (const kdl::Node& child : node.children) {
        const auto bone = context_.report.full() ? std::nullopt : read_bone(child);
        if (!bone)
            continue;
        const auto earlier = std::ranges::find(bones, bone->bone, &PosedBone::bone);
        if (earlier == bones.end())
            bones.push_back(*bone);
        else
            context_.report.error(bone->place, "this pose sets " + in_quotes(child.name) + " already, on " +
                                                   context_.report.line(earlier->place));
    }
    return bones;
}

std::optional<PosedBone> PoseReader::read_bone(const kdl::Node& node)
{
    if (!fits(node, bone_form(node.name), context_.report))
        return std::nullopt;
    const auto index = read_bone_name(node.name, node.name_span, bones_, context_);
    if (!index)
        return std::nullopt;
    PosedBone bone;
    bone.bone = *index;
    bone.place = node.name_span;
    read_properties(node, bone_rules, bone, context_);
    return bone;
}

std::vector<Pose> PoseReader::take()
{
    for (const Mention& mention : mentions_)
        look_up(mention);
    for (const Definition& definition : definitions_)
        if (!definition.is_used)
            context_.report.warning(definition.place,
                                    "the pose " + in_quotes(definition.name) + " is not used",
                                    "use it: pose TIME " + visible(definition.name) + ", or remove it");
    warn_of_idle_laws();
    refuse_two_drivers();
    take_scene_times();
    return std::move(poses_);
}

void PoseReader::take_scene_times()
{
    std::vector<Pose> timed;
    std::ranges::copy_if(poses_, std::back_inserter(timed),
                         [](const Pose& pose) { return pose.driver.is_time(); });
    // The transition to a pose is visible in part if it begins before the end.
    take_times(timed, 1, pose_name, context_);
}

void PoseReader::refuse_two_drivers()
{
    std::vector<const Pose*> first(bones_.size());
    for (const Pose& pose : poses_)
        for (const PosedBone& posed : pose.bones) {
            const Pose*& other = first[posed.bone];
            if (other == nullptr)
                other = &pose;
            if (other->driver.driver() == pose.driver.driver())
                continue;
            context_.report.error(pose.place,
                                  "the bone " + in_quotes(bones_[posed.bone].name) +
                                      " goes by something else on " + context_.report.line(other->place),
                                  "let all poses of a bone go by the time, or by one input; move it as well "
                                  "with a bone of its own as its parent");
            return;
        }
}

void PoseReader::look_up(const Mention& mention)
{
    const auto name = read_name(*mention.name, context_.report);
    if (!name)
        return;
    Pose& pose = poses_[mention.pose];
    const auto definition = std::ranges::find(definitions_, *name, &Definition::name);
    if (definition != definitions_.end()) {
        definition->is_used = true;
        set(pose, definition->bones);
    } else if (*name == rest_name) {
        set(pose, all_as_set_up(bones_.size(), pose.place));
    } else {
        std::vector<std::string_view> known{rest_name};
        for (const Definition& other : definitions_)
            known.push_back(other.name);
        context_.report.error(mention.name->place, "unknown pose " + in_quotes(*name),
                              suggestion(*name, known));
    }
}

/// Leaves them out if all poses together set too many; the first time, reports it.
void PoseReader::set(Pose& pose, std::vector<PosedBone> bones)
{
    const bool had_room = context_.posed_bones <= max_posed_bones;
    context_.posed_bones += bones.size();
    if (context_.posed_bones <= max_posed_bones)
        pose.bones = std::move(bones);
    else if (had_room)
        context_.report.error(
            pose.place, "the poses of this scene set more than " + std::to_string(max_posed_bones) + " bones",
            "let poses set only the bones that they move");
}

/// Those that govern nothing: no later pose sets one of the bones.
void PoseReader::warn_of_idle_laws()
{
    std::vector<bool> later(bones_.size());
    for (std::size_t i = poses_.size(); i-- > 0;) {
        const Pose& pose = poses_[i];
        if (!shares_a_bone(pose, later))
            for (const auto& rule : law_rules<Pose>)
                if (const std::string name{rule.name}; has_property(*pose.node, name))
                    context_.report.warning(property_span(*pose.node, name),
                                            "this " + name + " governs nothing",
                                            "remove it, or let a later pose set one of these bones");
        for (const PosedBone& posed : pose.bones)
            later[posed.bone] = true;
    }
}

std::vector<NodeSchema> pose_schema()
{
    constexpr std::string_view bone = "bone of pose";
    return {{pose_name, timed_form, {any_moment, any_name}, schema_of(pose_rules), {bone}},
            {pose_name, definition_form, {any_name}, {}, {bone}},
            {bone, bone_form("BONE"), {}, schema_of(bone_rules), {}, true}};
}

}
