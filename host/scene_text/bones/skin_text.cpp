#include "host/scene_text/bones/skin_text.hpp"

#include "host/scene/skeleton/binding.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/nodes.hpp"

#include <algorithm>

namespace kfast::scene_text {
namespace {

constexpr Grid fine_weights{4096, 1, 0, 1000};

scene::Binding binding_of(const std::vector<art::BoneInfluence>& shares)
{
    std::vector<scene::WeightedBone> bones;
    bones.reserve(shares.size());
    for (const art::BoneInfluence& share : shares)
        bones.push_back({share.bone, share.weight});
    return scene::bound(std::move(bones));
}

bool same(const scene::Binding& one, const scene::Binding& other)
{
    return std::ranges::equal(one, other, [](const scene::BoneWeight& left, const scene::BoneWeight& right) {
        return left.bone == right.bone && left.weight == right.weight;
    });
}

std::vector<kdl::Node> weight_nodes(const scene::Binding& binding, const RigNames& names)
{
    std::vector<kdl::Node> nodes;
    for (const scene::BoneWeight& bone : binding)
        nodes.push_back(named_node(names.bones[bone.bone],
                                   number(on_grid(bone.weight / 256.0, fine_weights), fine_weights)));
    return nodes;
}

kdl::Node points_node(std::size_t first, std::size_t last, const scene::Binding& binding,
                      const RigNames& names)
{
    kdl::Node points = named_node("points", number(first));
    if (last != first)
        points.arguments.push_back(number(last));
    points.children = weight_nodes(binding, names);
    return points;
}

}

void add_skin(kdl::Node& object, const art::Skin& skin, const RigNames& names)
{
    set(object, "skin", text(names.rig));
    std::vector<scene::Binding> bindings;
    for (const auto& point : skin.points)
        bindings.push_back(binding_of(point));
    const bool all_same =
        std::ranges::all_of(bindings, [&](const auto& one) { return same(one, bindings.front()); });
    if (all_same && bindings.front().size() == 1)
        set(object, "bone", text(names.bones[bindings.front().front().bone]));
    if (skin.turns_changes)
        set(object, "change", text("bones"));
    if (all_same && bindings.front().size() == 1)
        return;
    kdl::Node carried = named_node("weights");
    if (all_same)
        carried.children = weight_nodes(bindings.front(), names);
    for (std::size_t first = 0; !all_same && first < bindings.size();) {
        std::size_t last = first;
        while (last + 1 < bindings.size() && same(bindings[first], bindings[last + 1]))
            ++last;
        carried.children.push_back(points_node(first + 1, last + 1, bindings[first], names));
        first = last + 1;
    }
    object.children.push_back(std::move(carried));
}

}
