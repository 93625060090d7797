#include "host/scene/skeleton/bone_tree.hpp"

#include "core/math/angle.hpp"
#include "host/geometry/coordinate.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/bone_frames.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace kfast::scene {
namespace {

using Written = std::vector<WrittenBone>;

/// Roots first, then their children, then theirs; without those that hang on themselves.
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

/// From `bone` up until it comes again; nothing if it does not.
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

/// Once for each cycle, at the first of its bones.
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

}

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

}
