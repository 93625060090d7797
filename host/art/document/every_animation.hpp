#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"

#include <string>

namespace kfast::art {

/// Calls `visit` with everything that can change, of whatever type of value.
template <typename Visit>
void every_animation(Transform& transform, Visit&& visit)
{
    for (Channel* channel : {&transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y,
                             &transform.z, &transform.scale_x, &transform.scale_y, &transform.rotate,
                             &transform.rotate_x, &transform.rotate_y, &transform.skew, &transform.skew_axis})
        visit(*channel);
    if (transform.path)
        visit(transform.path->share);
}

template <typename Visit>
void every_animation(Shape& shape, Visit&& visit)
{
    visit(shape.drawing);
    if (shape.fill) {
        visit(shape.fill->colour);
        visit(shape.fill->opacity);
    }
    if (shape.stroke) {
        visit(shape.stroke->colour);
        visit(shape.stroke->opacity);
        visit(shape.stroke->width);
    }
}

template <typename Visit>
void every_animation(Bone& bone, Visit&& visit)
{
    for (Channel* channel : {&bone.rotation, &bone.x, &bone.y})
        visit(*channel);
    if (bone.length)
        visit(*bone.length);
}

/// Calls visit(node, place) with each node, the outer ones first; `place` are the names from the outermost
/// on, as Loss::layer has them. Throws Failure if they lie too deep in each other.
template <typename Visit>
void every_node(std::vector<Node>& nodes, Visit&& visit, const std::string& around = {}, int depth = 0)
{
    Budget::check_depth(depth);
    for (Node& node : nodes) {
        const std::string place = around.empty() ? node.name : around + " / " + node.name;
        visit(node, place);
        if (auto* group = std::get_if<Group>(&node.content))
            every_node(group->nodes, visit, place, depth + 1);
    }
}

}
