#include "host/scene_text/arrange/arrange.hpp"
#include "host/scene_text/arrange/passes.hpp"

#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <algorithm>
#include <iterator>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Group;
using art::Node;
using art::Shape;

bool is_always_zero(const Channel& channel, const Grid& grid)
{
    return std::ranges::all_of(channel.keys, [&](const auto& key) { return on_grid(key.value, grid) <= 0; });
}

bool draws(const Shape& shape)
{
    const auto is_drawn = [](const auto& key) { return !key.value.outlines.empty(); };
    return (shape.fill || shape.stroke) && std::ranges::any_of(shape.drawing.keys, is_drawn);
}

bool is_shown(const Node& node, std::int32_t length)
{
    const auto keys = visible_keys(node.shown, length);
    return std::ranges::any_of(keys, [](const auto& key) { return key.value; });
}

bool is_seen(Node& node, const Arranging& arranging)
{
    if (is_always_zero(node.opacity, opacities) || !is_shown(node, arranging.length))
        return false;
    if (auto* const group = std::get_if<Group>(&node.content)) {
        drop_unseen(group->nodes, arranging);
        return !group->nodes.empty();
    }
    if (const auto* const use = std::get_if<art::Use>(&node.content))
        return arranging.symbols[use->symbol].draws;
    auto& shape = std::get<Shape>(node.content);
    if (shape.fill && is_always_zero(shape.fill->opacity, opacities))
        shape.fill.reset();
    if (shape.stroke &&
        (is_always_zero(shape.stroke->opacity, opacities) || is_always_zero(shape.stroke->width, widths)))
        shape.stroke.reset();
    return draws(shape);
}

bool is_plain(const Node& node)
{
    return node.opacity == Channel{1} && node.shown == std::vector{art::Span{}};
}

bool are_parts(const Node& node, const Node& next)
{
    return node.parent_tag != 0 && node.parent_tag == next.parent_tag && is_plain(node) && is_plain(next) &&
           node.transform == next.transform && std::holds_alternative<Group>(node.content) &&
           std::holds_alternative<Group>(next.content);
}

}

void drop_unseen(std::vector<Node>& nodes, const Arranging& arranging)
{
    std::erase_if(nodes, [&arranging](Node& node) { return !is_seen(node, arranging); });
}

void join_parts(std::vector<Node>& nodes)
{
    std::vector<Node> joined;
    for (Node& node : nodes) {
        if (joined.empty() || !are_parts(joined.back(), node)) {
            joined.push_back(std::move(node));
            continue;
        }
        auto& into = std::get<Group>(joined.back().content).nodes;
        std::ranges::move(std::get<Group>(node.content).nodes, std::back_inserter(into));
    }
    nodes = std::move(joined);
    for (Node& node : nodes)
        if (auto* const group = std::get_if<Group>(&node.content))
            join_parts(group->nodes);
}

}
