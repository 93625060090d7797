#include "host/scene/skeleton/bones_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/skeleton/bone_tree.hpp"
#include "host/scene/skeleton/pose_keys.hpp"
#include "host/scene/skeleton/pose_reader.hpp"
#include "host/scene/skeleton/reach_keys.hpp"
#include "host/scene/skeleton/reach_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/glyph.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

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
    // Where bones are missing, whatever names them would be wrong as well.
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

NodeSchema bones_words()
{
    return {
        bones_name, bones_form, {any_name}, words_of(bones_rules), {known_nodes.begin(), known_nodes.end()}};
}

}
