#include "host/scene/skeleton/reach_reader.hpp"

#include "core/features.hpp"
#include "core/math/angle.hpp"
#include "core/time/track.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/bone_frames.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/scene/values/timed_quantity.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kfast::scene {

namespace {

constexpr NodeForm reach_form{reach_name, "reach BONE { at TIME X Y }", 1, 1, true};
constexpr NodeForm at_form{at_name, "at TIME X Y law=LAW", 3, 3};

constexpr std::array bends{Word<Bend>{"left", Bend::left}, Word<Bend>{"right", Bend::right}};

/// For a joint that is nearer to the line than this, the side to which it bends is unknown.
constexpr double straight = 1.0 / 16;

struct ReachProperties {
    std::optional<Bend> bend;
};

bool read_bend(const kdl::Value& value, ReachProperties& reach, SceneContext& context)
{
    return assign(read_word(value, bends, context.report), reach.bend);
}

constexpr std::array reach_rules{
    PropertyRule<ReachProperties>{"bend", read_bend, ValueKind::one_of<bends>()}};

struct AtProperties {
    KeyLaws laws;
};

constexpr std::array at_rules{PropertyRule<AtProperties>{"law", read_key_law<&KeyLaws::both>, any_law}};

struct WrittenTarget {
    const kdl::Node* node;
    ReachTarget target;
};

std::optional<std::size_t> read_bone(const kdl::Value& value, const std::vector<Bone>& bones,
                                     SceneContext& context)
{
    const auto name = read_name(value, context.report);
    if (!name)
        return std::nullopt;
    return read_bone_name(*name, value.place, bones, context);
}

bool check_chain(const Bone& bone, const std::vector<Bone>& bones, SourceSpan place, SceneContext& context)
{
    if (!bone.parent)
        return context.report.error(
            place, "to reach takes two bones, and " + in_quotes(bone.name) + " has no parent",
            "name the last bone of an arm or a leg");
    const std::string parent = in_quotes(bones[*bone.parent].name);
    return bone.is_at_tip ||
           context.report.error(place, in_quotes(bone.name) + " does not begin at the tip of " + parent,
                                "let it begin exactly where " + parent + " ends");
}

/// The side to which it bends as set up.
std::optional<Bend> bend_of(const std::vector<Bone>& bones, std::size_t bone)
{
    const std::vector<BoneFrame> frames = frames_as_set_up(bones);
    const Vec2 origin = frames[*bones[bone].parent].origin;
    const Vec2 tip = frames[bone].tip();
    const double side = cross(tip - origin, frames[bone].origin - origin);
    if (std::abs(side) <= straight * distance(origin, tip))
        return std::nullopt;
    return side > 0 ? Bend::right : Bend::left;
}

std::optional<WrittenTarget> read_target(const kdl::Node& node, SceneContext& context)
{
    if (node.name != at_form.name) {
        context.report.error(node.name_span, "a reach has no node " + in_quotes(node.name),
                             word_hint(node.name, std::array{at_form.name}));
        return std::nullopt;
    }
    if (!fits(node, at_form, context.report))
        return std::nullopt;
    AtProperties properties;
    const bool good = read_properties(node, at_rules, properties, context);
    const auto time = read_time(node.arguments.front(), context);
    const std::span<const kdl::Value> values{node.arguments};
    const auto spot = read_numbers(values.subspan(1), std::array{coordinates}, context.report);
    if (!good || !time || !spot)
        return std::nullopt;
    return WrittenTarget{&node,
                         {.time = *time,
                          .spot = {(*spot)[0], (*spot)[1]},
                          .law = properties.laws.of_rest().x,
                          .place = span(node.name_span, node.arguments.front().place)}};
}

PlacedMoment moment_of(const WrittenTarget& at) { return {at.target.time, at.target.place}; }

/// The targets are in any order, like the keys of tracks.
std::optional<std::vector<ReachTarget>> read_targets(const kdl::Node& node, SceneContext& context)
{
    std::vector<WrittenTarget> written;
    bool good = true;
    for (const kdl::Node& child : node.children) {
        const auto target = context.report.full() ? std::nullopt : read_target(child, context);
        good = target && good;
        if (target)
            written.push_back(*target);
    }
    std::ranges::stable_sort(written, {}, [](const WrittenTarget& at) { return at.target.time; });
    for (std::size_t i = 1; i < written.size(); ++i)
        good = comes_later("target", moment_of(written[i - 1]), moment_of(written[i]), {}, context) && good;
    if (node.children.empty())
        good = context.report.error(node.name_span, "this reach has no target", "add { at TIME X Y }");
    if (!good)
        return std::nullopt;
    if (has_property(*written.back().node, "law"))
        context.report.warning(property_span(*written.back().node, "law"), "this law governs nothing",
                               "remove it, or add a later target");
    std::vector<ReachTarget> targets;
    targets.reserve(written.size());
    for (const WrittenTarget& at : written)
        targets.push_back(at.target);
    return targets;
}

}

Vec2 target_at(const Reach& reach, Time time)
{
    const auto to = std::ranges::upper_bound(reach.targets, time, {}, &ReachTarget::time);
    const ReachTarget& from = *(to - 1);
    if (to == reach.targets.end())
        return from.spot;
    const Progress progress =
        progress_between(from.time, to->time, time, {from.law, from.law}, &kfast_springs).x;
    return from.spot + static_cast<double>(progress.raw) / Progress::one * (to->spot - from.spot);
}

std::optional<Reach> read_reach(const kdl::Node& node, const std::vector<Bone>& bones, SceneContext& context)
{
    if (!fits(node, reach_form, context.report))
        return std::nullopt;
    const kdl::Value& name = node.arguments.front();
    ReachProperties properties;
    const bool good = read_properties(node, reach_rules, properties, context);
    auto targets = read_targets(node, context);
    const auto bone = read_bone(name, bones, context);
    if (!bone || !check_chain(bones[*bone], bones, name.place, context) || !targets || !good)
        return std::nullopt;
    const auto bend = properties.bend ? properties.bend : bend_of(bones, *bone);
    const SourceSpan place = span(node.name_span, name.place);
    if (!bend) {
        context.report.error(place, "the bones are set up in a straight line, which tells no side to bend to",
                             "add bend=left or bend=right");
        return std::nullopt;
    }
    context.last_key = std::max(context.last_key, targets->back().time);
    return Reach{*bone, *bend, std::move(*targets), place};
}

std::vector<NodeSchema> reach_schema()
{
    constexpr std::string_view target = "at of reach";
    return {{reach_name, reach_form, {any_name}, schema_of(reach_rules), {target}},
            {target, at_form, {any_time, ValueKind::pixels(coordinates)}, schema_of(at_rules)}};
}

namespace {

constexpr double units_per_radian = BinaryAngle::turn / (2 * std::numbers::pi);

double angle_of(Vec2 direction) { return std::atan2(direction.y, direction.x) * units_per_radian; }

/// The angle at the origin of a triangle, of which `opposite` is the side that does not touch it. Sides that
/// do not meet are taken as parallel.
double corner(double side, double other, double opposite)
{
    const double product = 2 * side * other;
    if (product == 0)
        return 0;
    const double cosine = (side * side + other * other - opposite * opposite) / product;
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * units_per_radian;
}

}

Vec2 Arm::tip(double upper, double lower) const
{
    const BoneFrame upper_frame{base.origin, base.angle + upper, 0};
    return BoneFrame{upper_frame.outside(joint), upper_frame.angle + lower, lower_length}.tip();
}

Arm arm_at(const std::vector<Bone>& bones, std::size_t bone, Time time)
{
    const std::size_t upper = *bones[bone].parent;
    BoneFrame base = frame_at(bones, upper, time);
    const double stretch = lengthening_of(bones[upper], base);
    base.angle -= values_at(bones[upper], time).front();
    const BoneFrame lower = frame_in({}, bones[bone], values_at(bones[bone], time), stretch);
    return {base, lower.origin, lower.length};
}

ArmAngles angles_reaching(const Arm& arm, Vec2 target, Bend bend)
{
    const double upper_length = distance({}, arm.joint);
    const double bent = corner(upper_length, distance(arm.base.origin, target), arm.lower_length);
    const double towards = angle_of(target - arm.base.origin);
    const double to_joint = towards + (bend == Bend::right ? bent : -bent);
    const double upper = to_joint - angle_of(arm.joint) - arm.base.angle;
    const Vec2 joint = arm.base.origin + upper_length * direction_of(to_joint);
    const double lower = angle_of(target - joint) - arm.base.angle - upper;
    return {upper, lower};
}

}
