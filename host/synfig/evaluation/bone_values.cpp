#include "host/synfig/evaluation/evaluator.hpp"

#include <cmath>

namespace kfast::synfig {
namespace {

/// The mean matrix of several bones.
art::Affine mean(const std::vector<Value>& pairs)
{
    art::Affine total{0, 0, 0, 0, 0, 0};
    double weights = 0;
    for (const Value& pair : pairs) {
        const auto parts = pair.as<List>().entries;
        if (parts.size() != 2)
            continue;
        const double weight = parts[1].number();
        const art::Affine one = parts[0].as<Bone>().carrying();
        total = {total.a + weight * one.a, total.b + weight * one.b, total.c + weight * one.c,
                 total.d + weight * one.d, total.e + weight * one.e, total.f + weight * one.f};
        weights += weight;
    }
    if (std::abs(weights) <= 1e-6)
        return {};
    return {total.a / weights, total.b / weights, total.c / weights,
            total.d / weights, total.e / weights, total.f / weights};
}

Vec2 direction(const art::Affine& matrix, Vec2 spot)
{
    return {matrix.a * spot.x + matrix.c * spot.y, matrix.b * spot.x + matrix.d * spot.y};
}

Value carried(const art::Affine& matrix, const Value& value)
{
    if (const Vec2* spot = std::get_if<Vec2>(&value.held))
        return {matrix.of(*spot)};
    if (const SplinePoint* found = std::get_if<SplinePoint>(&value.held)) {
        SplinePoint point = *found;
        point.vertex = matrix.of(point.vertex);
        point.second = direction(matrix, point.second);
        point.arriving = direction(matrix, point.arriving);
        return {point};
    }
    if (const Placement* placement = std::get_if<Placement>(&value.held))
        return {Placement::of(matrix * placement->matrix())};
    return value;
}

Value bone(Evaluator& evaluator, const ValueNode& node, double time)
{
    Bone bone;
    bone.name = evaluator.link(node, "name", time).as<std::string>();
    bone.guid = node.constant.as<BoneName>().guid;
    const Value parent_link = evaluator.link(node, "parent", time);
    bone.parent = std::holds_alternative<Bone>(parent_link.held) ? parent_link.as<Bone>().guid
                                                                 : parent_link.as<BoneName>().guid;
    const Bone parent = evaluator.bone(bone.parent, time);
    const Vec2 origin = evaluator.spot(node, "origin", time);
    const double angle = evaluator.number(node, "angle", time);
    // This scale applies to descendants of the bone as well; the other one to itself alone.
    const double scale_factor = evaluator.number(node, "scalex", time, 1);
    bone.stretch = evaluator.number(node, "scalelx", time, 1);
    bone.length = std::max(1e-5, evaluator.number(node, "length", time, 1));
    bone.width = std::abs(evaluator.number(node, "width", time, 0.1));
    bone.tip_width = std::abs(evaluator.number(node, "tipwidth", time, 0.1));
    bone.depth = evaluator.number(node, "bone_depth", time);
    bone.angle = parent.angle + angle;
    bone.matrix = parent.matrix * art::moved(origin.x * parent.stretch, origin.y) * art::turned(angle) *
                  art::grown(scale_factor, 1);
    return {bone};
}

Value bone_root(Evaluator&, const ValueNode&, double) { return {Bone{}}; }

Value bone_weight(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Bone bone = evaluator.bone(evaluator.link(node, "bone", time).as<BoneName>().guid, time);
    return {List{{{bone}, {evaluator.number(node, "weight", time)}}, false}};
}

Value bone_influence(Evaluator& evaluator, const ValueNode& node, double time)
{
    return carried(mean(evaluator.link(node, "bone_weight_list", time).as<List>().entries),
                   evaluator.link(node, "link", time));
}

Value bone_link(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Value base = evaluator.link(node, "base_value", time);
    const Bone bone = evaluator.bone(evaluator.link(node, "bone", time).as<BoneName>().guid, time);
    Placement placement = Placement::of(bone.carrying());
    if (!evaluator.truth(node, "translate", time, true))
        placement.offset = {};
    if (!evaluator.truth(node, "rotate", time, true))
        placement.angle = placement.skew = 0; // Synfig 1.5.1 confuses the two
    if (!evaluator.truth(node, "scale_x", time, true))
        placement.scale.x = 1;
    if (!evaluator.truth(node, "scale_y", time, true))
        placement.scale.y = 1;
    if (std::holds_alternative<double>(base.held))
        return {base.number() + (node.type == "angle" ? placement.angle : 0)};
    return carried(placement.matrix(), base);
}

}

ValueLaws bone_laws()
{
    return {{"bone", bone},
            {"bone_root", bone_root},
            {"boneweightpair", bone_weight},
            {"bone_weight_pair", bone_weight},
            {"boneinfluence", bone_influence},
            {"bone_link", bone_link}};
}

}
