#include "host/scene_text/arrange/passes.hpp"

#include "host/art/document/document.hpp"
#include "host/scene_text/arrange/carrying.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <iterator>

namespace kfast::scene_text {
namespace {

using art::Affine;
using art::Channel;
using art::Group;
using art::Node;
using art::Span;
using art::Transform;

bool is_plain(const Node& node)
{
    return is_identity(node.transform) && node.opacity == Channel{1} && node.shown == std::vector{Span{}};
}

/// Scale and skew come first, so if they are constant they can be applied to the content instead; and then
/// rotation, if it is constant, too.
Affine still_shape(const Transform& transform)
{
    if (!transform.scale_x.is_still() || !transform.scale_y.is_still() || !transform.skew.is_still() ||
        !transform.skew_axis.is_still())
        return {};
    Transform shape = transform;
    if (!transform.rotate.is_still())
        shape.rotate = {0};
    return shape_at(shape, 0);
}

void fold_shape(Node& node)
{
    Transform& transform = node.transform;
    const Affine shape = still_shape(transform);
    if (shape == Affine{} || !transform.anchor_x.is_still() || !transform.anchor_y.is_still() ||
        !content_can_take(shape, node))
        return;
    content_takes(shape, node);
    const scene::Vec2 anchor = shape.of(scene::Vec2{transform.anchor_x.value(), transform.anchor_y.value()});
    transform.anchor_x = {anchor.x};
    transform.anchor_y = {anchor.y};
    transform.scale_x = transform.scale_y = {1};
    transform.skew = transform.skew_axis = {0};
    if (transform.rotate.is_still())
        transform.rotate = {0};
}

bool only_moves(const Transform& transform)
{
    Transform rest = transform;
    rest.path.reset();
    rest.x = rest.y = rest.z = rest.anchor_x = rest.anchor_y = {0};
    return is_identity(rest) && !(transform.path && transform.path->turns);
}

/// So that what is still is drawn where it is seen, and what rotates has its anchor where it is seen.
void fold_place(Node& node)
{
    Transform& transform = node.transform;
    if (!transform.anchor_x.is_still() || !transform.anchor_y.is_still())
        return;
    const scene::Vec2 anchor{transform.anchor_x.value(), transform.anchor_y.value()};
    const bool stands = !transform.path && transform.x.is_still() && transform.y.is_still();
    const bool moves = only_moves(transform);
    if (!stands && !moves)
        return;
    const scene::Vec2 place = stands ? scene::Vec2{transform.x.value(), transform.y.value()} : scene::Vec2{};
    const Affine move = art::moved(place.x - anchor.x, place.y - anchor.y);
    if (move == Affine{} || !content_can_take(move, node))
        return;
    content_takes(move, node);
    const scene::Vec2 pivot = moves ? scene::Vec2{} : place;
    transform.anchor_x = {pivot.x};
    transform.anchor_y = {pivot.y};
    if (stands) {
        transform.x = {pivot.x};
        transform.y = {pivot.y};
    }
}

/// A pivot of what does not rotate or scale does nothing.
void tidy(Transform& transform)
{
    if (!only_moves(transform) || transform.path)
        return;
    if (!has_sum(transform.x, transform.anchor_x) || !has_sum(transform.y, transform.anchor_y))
        return;
    transform.x = sum(transform.x, scaled(transform.anchor_x, -1));
    transform.y = sum(transform.y, scaled(transform.anchor_y, -1));
    transform.anchor_x = transform.anchor_y = {0};
}

bool can_follow(const Transform& outer, const Transform& inner)
{
    return only_moves(outer) && !outer.path && !inner.path && outer.anchor_x == Channel{0} &&
           outer.anchor_y == Channel{0} && has_sum(outer.x, inner.x) && has_sum(outer.y, inner.y) &&
           has_sum(outer.z, inner.z);
}

/// Whether the steps of its copies are about its own (0, 0), which the anchor of another would move.
bool has_copies(const Node& node)
{
    const auto* const use = std::get_if<art::Use>(&node.content);
    return use != nullptr && use->copies.count > 1;
}

bool can_be_one(const Node& group, const Node& inner)
{
    if (has_copies(inner) &&
        (group.transform.anchor_x != Channel{0} || group.transform.anchor_y != Channel{0}))
        return false;
    return has_product(group.opacity, inner.opacity) &&
           (is_identity(group.transform) || is_identity(inner.transform) ||
            can_follow(group.transform, inner.transform));
}

void join_transforms(const Transform& outer, Transform& inner)
{
    if (is_identity(inner)) {
        inner = outer;
    } else if (!is_identity(outer)) {
        inner.x = sum(outer.x, inner.x);
        inner.y = sum(outer.y, inner.y);
        inner.z = sum(outer.z, inner.z);
    }
}

/// Merges the group and the only node in it.
void become_one(Node& group)
{
    Node inner = std::move(std::get<Group>(group.content).nodes.front());
    join_transforms(group.transform, inner.transform);
    inner.opacity = product(group.opacity, inner.opacity);
    inner.shown = common(group.shown, inner.shown);
    // A parent has a name of its own; its child is what is visible.
    if (inner.name.empty() || (!group.name.empty() && group.parent_tag == 0))
        inner.name = std::move(group.name);
    group = std::move(inner);
}

void fold_node(Node& node)
{
    if (auto* const group = std::get_if<Group>(&node.content))
        fold(group->nodes);
    fold_shape(node);
    fold_place(node);
    tidy(node.transform);
    const auto* const group = std::get_if<Group>(&node.content);
    if (group != nullptr && group->nodes.size() == 1 && can_be_one(node, group->nodes.front()))
        become_one(node);
}

bool dissolves(const Node& node)
{
    return std::holds_alternative<Group>(node.content) && is_plain(node) && node.name.empty();
}

}

void fold(std::vector<Node>& nodes)
{
    std::vector<Node> folded;
    for (Node& node : nodes) {
        fold_node(node);
        if (dissolves(node))
            std::ranges::move(std::get<Group>(node.content).nodes, std::back_inserter(folded));
        else
            folded.push_back(std::move(node));
    }
    nodes = std::move(folded);
}

}
