#include "host/scene_text/arrange/depth.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene_text/arrange/baking.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/arrange/spans.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <iterator>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Group;
using art::Node;

/// Of groups in each other.
int depth_of(const std::vector<Node>& nodes)
{
    int depth = 0;
    for (const Node& node : nodes)
        if (const auto* const group = std::get_if<Group>(&node.content))
            depth = std::max(depth, 1 + depth_of(group->nodes));
    return depth;
}

bool is_plain(const Node& node)
{
    return std::holds_alternative<Group>(node.content) && is_identity(node.transform) &&
           node.opacity == Channel{1} && node.shown == std::vector{art::Span{}};
}

/// Puts the nodes of groups where the groups are.
template <typename Dissolves>
void dissolve(std::vector<Node>& nodes, Dissolves dissolves)
{
    std::vector<Node> flat;
    for (Node& node : nodes)
        if (dissolves(node))
            std::ranges::move(std::get<Group>(node.content).nodes, std::back_inserter(flat));
        else
            flat.push_back(std::move(node));
    nodes = std::move(flat);
}

class Depth {
public:
    explicit Depth(const Arranging& arranging) : arranging_{arranging} {}

    /// `room` is how many groups may lie in each other here.
    void limit(std::vector<Node>& nodes, int room)
    {
        if (depth_of(nodes) <= room)
            return;
        for (Node& node : nodes)
            if (auto* const group = std::get_if<Group>(&node.content))
                limit(group->nodes, std::max(room - 1, 0));
        // Groups that are only names go first.
        dissolve(nodes, [&](const Node& node) { return is_plain(node) && too_deep(node, room); });
        if (depth_of(nodes) <= room)
            return;
        for (Node& node : nodes)
            if (std::holds_alternative<Group>(node.content) && too_deep(node, room))
                flatten(node);
        dissolve(nodes, [&](const Node& node) { return is_plain(node) && too_deep(node, room); });
    }

private:
    static bool too_deep(const Node& node, int room)
    {
        const auto* const group = std::get_if<Group>(&node.content);
        return group != nullptr && 1 + depth_of(group->nodes) > room;
    }

    /// Leaves nothing to do for the group itself.
    void flatten(Node& node)
    {
        if (!is_identity(node.transform))
            bake(node, arranging_);
        std::vector<Node>& inner = std::get<Group>(node.content).nodes;
        if (node.opacity != Channel{1} && inner.size() > 1)
            arranging_.losses.add({"opacity of a group, so deep inside of groups",
                                   node.name,
                                   {},
                                   "its parts are transparent each for itself"});
        for (Node& part : inner) {
            part.opacity = product(part.opacity, node.opacity, {opacity_step, arranging_.budget});
            part.shown = common(part.shown, node.shown);
        }
        node.opacity = {1};
        node.shown = std::vector{art::Span{}};
    }

    static constexpr double opacity_step = 1.0 / 512;

    const Arranging& arranging_;
};

}

void limit_depth(std::vector<Node>& nodes, const Arranging& arranging)
{
    Depth{arranging}.limit(nodes, scene::deepest_item);
}

}
