#include "host/scene/bone_reader.hpp"

#include "host/scene/limits.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/spot_reader.hpp"
#include "host/scene/synonyms.hpp"
#include "host/scene/value_reader.hpp"
#include "host/scene/weights_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm bone_form{bone_name, "bone NAME X Y X Y", 5, 5, true};

bool read_region(const kdl::Value& value, WrittenBone& bone, Reading& reading)
{
    return assign(read_number(value, extents, reading), bone.region);
}

bool read_tip(const kdl::Value& value, WrittenBone& bone, Reading& reading)
{
    return assign(read_flag(value, reading), bone.tip);
}

bool keep_parent(const kdl::Value& value, WrittenBone& bone, Reading& reading)
{
    bone.parent_name = &value;
    return read_name(value, reading).has_value();
}

constexpr std::array bone_rules{
    PropertyRule<WrittenBone>{"region", read_region, ValueKind::pixels(extents)},
    PropertyRule<WrittenBone>{"tip", read_tip, truth},
    PropertyRule<WrittenBone>{"parent", keep_parent, any_name},
};

bool read_ends(const kdl::Node& node, WrittenBone& bone, Reading& reading)
{
    const std::span<const kdl::Value> values{node.arguments};
    const auto numbers = read_numbers(values.subspan(1), std::array{coordinates}, reading);
    if (!numbers)
        return false;
    bone.from = {(*numbers)[0], (*numbers)[1]};
    bone.to = {(*numbers)[2], (*numbers)[3]};
    return true;
}

}

std::vector<WrittenBone> BoneReader::take()
{
    for (WrittenBone& bone : bones_)
        if (bone.parent_name != nullptr)
            find_parent(bone);
    return std::move(bones_);
}

void BoneReader::read(const kdl::Node& node, std::optional<std::size_t> parent)
{
    if (is_full_ || reading_.report.full())
        return;
    if (!fits(node, bone_form, reading_)) {
        is_good_ = false;
        return;
    }
    WrittenBone bone = read_bone(node, parent);
    if (!has_room(bone))
        return;
    is_good_ = bone.is_good && is_good_;
    const std::size_t index = bones_.size();
    bones_.push_back(std::move(bone));
    for (const kdl::Node& child : node.children)
        if (child.name == bone_name)
            read(child, index);
        else
            is_good_ = reading_.report.error(child.name_place, "a bone has no node " + in_quotes(child.name),
                                             word_remedy(child.name, std::array{bone_name}));
}

WrittenBone BoneReader::read_bone(const kdl::Node& node, std::optional<std::size_t> parent)
{
    WrittenBone bone;
    bone.node = &node;
    bone.parent = parent;
    bone.place = span(node.name_place, node.arguments.front().place);
    bone.is_good = read_properties(node, bone_rules, bone, reading_);
    if (parent && bone.parent_name != nullptr) {
        bone.is_good = reading_.report.error(property_place(node, "parent"),
                                             "this bone stands inside of its parent already",
                                             "remove parent=…, or write the bone outside of the other");
        bone.parent_name = nullptr;
    }
    if (bone.tip && !parent && bone.parent_name == nullptr)
        reading_.report.warning(property_place(node, "tip"), "tip does nothing without a parent",
                                "remove it, or add parent=…");
    bone.is_good = read_ends(node, bone, reading_) && bone.is_good;
    const auto name = read_name(node.arguments.front(), reading_);
    bone.name = name.value_or("");
    if (bone.name == points_name)
        bone.is_good =
            reading_.report.error(node.arguments.front().place, "a bone cannot be called \"points\"",
                                  "choose another name: weights have a node of this one");
    bone.is_good = name && add_name(names_, "a bone", *name, bone.place, reading_.report) && bone.is_good;
    return bone;
}

bool BoneReader::has_room(const WrittenBone& bone)
{
    if (bones_.size() < most_bones)
        return true;
    is_full_ = true;
    is_good_ =
        reading_.report.error(bone.place, "a skeleton has at most " + std::to_string(most_bones) + " bones");
    return false;
}

void BoneReader::find_parent(WrittenBone& bone)
{
    const std::string* const name = bone.parent_name->string();
    if (name == nullptr)
        return;
    const auto parent = std::ranges::find(bones_, *name, &WrittenBone::name);
    if (parent != bones_.end()) {
        bone.parent = static_cast<std::size_t>(parent - bones_.begin());
        return;
    }
    std::vector<std::string_view> known;
    for (const WrittenBone& other : bones_)
        known.push_back(other.name);
    is_good_ = reading_.report.error(bone.parent_name->place, "unknown bone " + in_quotes(*name),
                                     suggestion(*name, known));
}

NodeWords bone_words()
{
    return {
        bone_name, bone_form, {any_name, ValueKind::pixels(coordinates)}, words_of(bone_rules), {bone_name}};
}

}
