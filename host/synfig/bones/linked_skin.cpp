#include "host/synfig/bones/linked_skin.hpp"

#include "host/scene/context/limits.hpp"
#include "host/synfig/bones/posed_rig.hpp"
#include "host/synfig/evaluation/value_bends.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace kfast::synfig {
namespace {

constexpr double same_growth = 1e-4;

bool is_constant(const ValueNode& node)
{
    return node.waypoints.empty() &&
           (node.kind == "constant" || node.kind == "composite" || node.kind == "radial_composite" ||
            node.kind == "boneweightpair") &&
           std::ranges::all_of(node.links, [](const auto& link) { return is_constant(*link.second); });
}

/// Whether a switch of a link has its default value.
bool is_on(const ValueNode& node, const char* name)
{
    const ValueNode* link = node.link(name);
    return !link || (link->kind == "constant" && link->constant.truth());
}

/// The bone that a value is linked to in all respects, or empty. Directions do not move with its position.
std::string bone_of(const ValueNode* node, bool is_direction)
{
    if (!node || node->kind != "bone_link")
        return {};
    const ValueNode* bone = node->link("bone");
    const ValueNode* base = node->link("base_value");
    const bool whole = is_on(*node, "rotate") && is_on(*node, "scale_x") && is_on(*node, "scale_y") &&
                       is_on(*node, "translate") != is_direction;
    if (!whole || !bone || bone->kind != "constant" || !base || !is_constant(*base))
        return {};
    return bone->constant.as<BoneName>().guid;
}

bool is_nothing(const ValueNode* node, Evaluator& evaluator)
{
    if (!node)
        return true;
    const Vec2 spot = is_constant(*node) ? evaluator.at(*node, 0).as<Vec2>() : Vec2{1, 1};
    return scene::dot(spot, spot) < 1e-16;
}

/// The bones of the points of a spline; none if one of them is not linked that way.
std::vector<std::string> bones_of_points(const Layer& layer)
{
    const ValueNode* spline = layer.parameter("bline");
    std::vector<std::string> bones;
    if (!spline || spline->kind != "bline")
        return bones;
    Evaluator& evaluator = layer.reading().evaluator;
    for (const Entry& entry : spline->entries) {
        const ValueNode& point = *entry.value;
        const std::string bone = bone_of(point.link(point.link("point") ? "point" : "vertex"), false);
        const auto goes_along = [&](const char* name) {
            return is_nothing(point.link(name), evaluator) || bone_of(point.link(name), true) == bone;
        };
        if (point.kind != "composite" || bone.empty() || !entry.switchings.empty() || !goes_along("t1") ||
            !goes_along("t2"))
            return {};
        bones.push_back(bone);
    }
    return bones;
}

class Linking {
public:
    explicit Linking(Reading& reading) : reading_{reading} {}

    /// Nothing if the tree cannot be a skeleton.
    const LinkedRig* rig_with(const std::string& bone)
    {
        const std::string root = root_of(bone);
        const auto known = reading_.linked_rigs.find(root);
        if (known != reading_.linked_rigs.end())
            return known->second.bones.empty() ? nullptr : &known->second;
        LinkedRig& linked = reading_.linked_rigs[root];
        std::vector<std::string> tree;
        for (const std::string& guid : reading_.file.bones())
            if (root_of(guid) == root)
                tree.push_back(guid);
        if (tree.empty() || tree.size() > scene::max_bones || !keep_their_shape(tree))
            return nullptr;
        const PosedRig posed = posed_rig(posed_bones(tree), reading_);
        linked.rig = reading_.rigs.size();
        for (std::size_t i = 0; i < tree.size(); ++i)
            linked.bones[tree[i]] = posed.place[i];
        reading_.rigs.push_back(posed.rig);
        return &linked;
    }

private:
    Bone at(const std::string& guid, double frame) const
    {
        return reading_.evaluator.bone(guid, reading_.begin + frame / reading_.frame_rate);
    }

    std::string root_of(std::string guid) const
    {
        for (Bone bone = at(guid, 0); reading_.values.bone(bone.parent); bone = at(guid, 0))
            guid = bone.parent;
        return guid;
    }

    std::vector<double> bends(const std::vector<std::string>& tree) const
    {
        ValueBends bends{reading_.values, reading_.begin,
                         reading_.begin + reading_.frames / reading_.frame_rate};
        for (const std::string& guid : tree)
            bends.add(*reading_.values.bone(guid));
        std::vector<double> frames;
        const Driver clock{reading_.begin, reading_.frame_rate};
        for (const double time : bends.times())
            std::ranges::copy(clock.frames(time, reading_.frames), std::back_inserter(frames));
        return frames;
    }

    /// Bones of scenes do not scale their descendants, nor anything across themselves.
    bool keep_their_shape(const std::vector<std::string>& tree) const
    {
        std::vector<double> times = bends(tree);
        for (int i = 0; i <= 8; ++i)
            times.push_back(reading_.frames * i / 8);
        return std::ranges::all_of(times, [&](double time) {
            return std::ranges::all_of(tree, [&](const std::string& guid) {
                const Bone bone = at(guid, time);
                const art::Affine& matrix = bone.matrix;
                return std::abs(std::hypot(matrix.a, matrix.b) - 1) < same_growth &&
                       std::abs(std::hypot(matrix.c, matrix.d) - 1) < same_growth &&
                       matrix.determinant() > 0 && bone.stretch > 0 && bone.length * bone.stretch > 1e-3;
            });
        });
    }

    PosedBones posed_bones(const std::vector<std::string>& tree) const
    {
        const auto pairs_at = [this, tree](double frame) {
            std::vector<BonePair> pairs;
            pairs.reserve(tree.size());
            for (const std::string& guid : tree)
                pairs.push_back({at(guid, 0), at(guid, frame)});
            return pairs;
        };
        return {at(root_of(tree.front()), 0).name, pairs_at, bends(tree)};
    }

    Reading& reading_;
};

}

std::optional<art::Skin> linked_skin(const Layer& layer)
{
    if (layer.scope().is_deformed || !layer.scope().clock.is_plain())
        return {};
    const std::vector<std::string> bones = bones_of_points(layer);
    if (bones.size() < 2)
        return {};
    art::Skin skin;
    const LinkedRig* first = nullptr;
    for (const std::string& guid : bones) {
        const LinkedRig* rig = Linking{layer.reading()}.rig_with(guid);
        if (!rig || (first && rig->rig != first->rig) || !rig->bones.contains(guid))
            return {};
        first = rig;
        skin.rig = rig->rig;
        skin.points.push_back({{rig->bones.at(guid), 1}});
    }
    return skin;
}

}
