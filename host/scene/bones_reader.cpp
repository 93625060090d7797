#include "host/scene/bones_reader.hpp"

#include "host/scene/bone_reader.hpp"
#include "host/scene/bone_tree.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/pose_keys.hpp"
#include "host/scene/pose_reader.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/reach_keys.hpp"
#include "host/scene/reach_reader.hpp"
#include "host/scene/synonyms.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

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

bool read_turns(const kdl::Value& value, BonesProperties& bones, Reading& reading)
{
    return assign(read_word(value, turn_words, reading), bones.turns_as_written);
}

constexpr std::array bones_rules{
    PropertyRule<BonesProperties>{"turns", read_turns, ValueKind::one_of<turn_words>()}};

void refuse_unknown_nodes(const kdl::Node& node, Reading& reading)
{
    for (const kdl::Node& child : node.children)
        if (std::ranges::find(known_nodes, child.name) == known_nodes.end() && !reading.report.full())
            reading.report.error(child.name_place, "a skeleton has no node " + in_quotes(child.name),
                                 word_remedy(child.name, known_nodes));
}

bool has_room(const Skeleton& skeleton, Reading& reading)
{
    if (reading.skeletons.entries.size() == most_skeletons)
        return reading.report.error(skeleton.bones.place,
                                    "a scene has at most " + std::to_string(most_skeletons) + " skeletons");
    return reading.skeletons.bone_count() + skeleton.bones.bones.size() <= most_bones_together ||
           reading.report.error(skeleton.bones.place, "the skeletons of a scene have at most " +
                                                          std::to_string(most_bones_together) +
                                                          " bones together");
}

void read_bones(const kdl::Node& node, Skeleton& skeleton, Reading& reading)
{
    BoneReader reader{reading};
    for (const kdl::Node& child : node.children)
        if (child.name == bone_name)
            reader.read(child);
    const std::vector<WrittenBone> written = reader.take();
    skeleton.is_good = reader.is_good();
    if (written.empty() && skeleton.is_good)
        skeleton.is_good = reading.report.error(skeleton.bones.place, "this skeleton has no bones",
                                                "add { bone NAME X Y X Y }");
    set_up_bones(written, skeleton, reading);
}

void read_movement(const kdl::Node& node, std::vector<Bone>& bones, Reading& reading)
{
    PoseReader poses{bones, reading};
    std::vector<Reach> reaches;
    for (const kdl::Node& child : node.children) {
        if (reading.report.full())
            return;
        if (child.name == pose_name)
            poses.read(child);
        else if (child.name == reach_name)
            if (auto reach = read_reach(child, bones, reading))
                reaches.push_back(std::move(*reach));
    }
    const std::vector<GivenTurn> turns = add_pose_keys(poses.take(), bones, reading);
    add_reach_keys(std::move(reaches), turns, bones, reading);
    tidy_keys(bones);
}

}

void add_skeleton(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, bones_form, reading))
        return;
    Skeleton skeleton;
    skeleton.bones.place = span(node.name_place, node.arguments.front().place);
    BonesProperties properties;
    read_properties(node, bones_rules, properties, reading);
    refuse_unknown_nodes(node, reading);
    read_bones(node, skeleton, reading);
    for (Bone& bone : skeleton.bones.bones)
        bone.turns_as_written = properties.turns_as_written;
    // Where bones are missing, whatever names them would be wrong as well.
    if (skeleton.is_good)
        read_movement(node, skeleton.bones.bones, reading);
    const auto name = read_name(node.arguments.front(), reading);
    if (!name || !has_room(skeleton, reading))
        return;
    skeleton.bones.name = *name;
    if (const auto earlier = reading.skeletons.find(*name))
        report_double("a skeleton", *name, skeleton.bones.place,
                      reading.skeletons.entries[*earlier].bones.place, reading.report);
    else
        reading.skeletons.entries.push_back(std::move(skeleton));
}

void warn_of_unused_skeletons(Reading& reading)
{
    for (const Skeleton& skeleton : reading.skeletons.entries)
        if (!skeleton.is_used)
            reading.report.warning(
                skeleton.bones.place, "the skeleton " + in_quotes(skeleton.bones.name) + " carries nothing",
                "add skin=" + visible(skeleton.bones.name) + " to an object, or remove it");
}

NodeWords bones_words()
{
    return {
        bones_name, bones_form, {any_name}, words_of(bones_rules), {known_nodes.begin(), known_nodes.end()}};
}

}
