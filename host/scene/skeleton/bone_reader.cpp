#include "host/scene/skeleton/bone_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/skeleton/weights_reader.hpp"
#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <utility>

namespace kfast::scene {

namespace {

constexpr NodeForm bone_form{bone_name, "bone NAME X Y X Y", 5, 5, true};

bool read_region(const kdl::Value& value, WrittenBone& bone, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), bone.region);
}

bool read_tip(const kdl::Value& value, WrittenBone& bone, SceneContext& context)
{
    return assign(read_flag(value, context.report), bone.tip);
}

bool keep_parent(const kdl::Value& value, WrittenBone& bone, SceneContext& context)
{
    bone.parent_name = &value;
    return read_name(value, context.report).has_value();
}

constexpr std::array bone_rules{
    PropertyRule<WrittenBone>{"region", read_region, ValueKind::pixels(extents)},
    PropertyRule<WrittenBone>{"tip", read_tip, truth},
    PropertyRule<WrittenBone>{"parent", keep_parent, any_name},
};

bool read_ends(const kdl::Node& node, WrittenBone& bone, SceneContext& context)
{
    const std::span<const kdl::Value> values{node.arguments};
    const auto numbers = read_numbers(values.subspan(1), std::array{coordinates}, context.report);
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
    if (is_full_ || context_.report.full())
        return;
    if (!fits(node, bone_form, context_.report)) {
        is_valid_ = false;
        return;
    }
    WrittenBone bone = read_bone(node, parent);
    if (!has_capacity(bone))
        return;
    is_valid_ = bone.is_valid && is_valid_;
    const std::size_t index = bones_.size();
    bones_.push_back(std::move(bone));
    for (const kdl::Node& child : node.children)
        if (child.name == bone_name)
            read(child, index);
        else
            is_valid_ = context_.report.error(child.name_span, "a bone has no node " + in_quotes(child.name),
                                              word_hint(child.name, std::array{bone_name}));
}

WrittenBone BoneReader::read_bone(const kdl::Node& node, std::optional<std::size_t> parent)
{
    WrittenBone bone;
    bone.node = &node;
    bone.parent = parent;
    bone.place = span(node.name_span, node.arguments.front().place);
    bone.is_valid = read_properties(node, bone_rules, bone, context_);
    if (parent && bone.parent_name != nullptr) {
        bone.is_valid = context_.report.error(property_span(node, "parent"),
                                              "this bone stands inside of its parent already",
                                              "remove parent=…, or write the bone outside of the other");
        bone.parent_name = nullptr;
    }
    if (bone.tip && !parent && bone.parent_name == nullptr)
        context_.report.warning(property_span(node, "tip"), "tip does nothing without a parent",
                                "remove it, or add parent=…");
    bone.is_valid = read_ends(node, bone, context_) && bone.is_valid;
    const auto name = read_name(node.arguments.front(), context_.report);
    bone.name = name.value_or("");
    if (bone.name == points_name)
        bone.is_valid =
            context_.report.error(node.arguments.front().place, "a bone cannot be called \"points\"",
                                  "choose another name: weights have a node of this one");
    bone.is_valid = name && add_name(names_, "a bone", *name, bone.place, context_.report) && bone.is_valid;
    return bone;
}

bool BoneReader::has_capacity(const WrittenBone& bone)
{
    if (bones_.size() < max_bones)
        return true;
    is_full_ = true;
    is_valid_ =
        context_.report.error(bone.place, "a skeleton has at most " + std::to_string(max_bones) + " bones");
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
    is_valid_ = context_.report.error(bone.parent_name->place, "unknown bone " + in_quotes(*name),
                                      suggestion(*name, known));
}

NodeSchema bone_schema()
{
    return {
        bone_name, bone_form, {any_name, ValueKind::pixels(coordinates)}, schema_of(bone_rules), {bone_name}};
}

std::optional<std::size_t> read_bone_name(std::string_view name, SourceSpan place,
                                          const std::vector<Bone>& bones, SceneContext& context)
{
    const auto bone = find_bone(bones, name);
    if (!bone)
        context.report.error(place, "unknown bone " + in_quotes(name), suggestion(name, names_of(bones)));
    return bone;
}

}
