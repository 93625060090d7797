#include "host/scene_text/arrange/carrying.hpp"

#include "host/art/document/document.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::scene_text {
namespace {

using art::Affine;
using art::Channel;
using art::Group;
using art::Node;
using art::Shape;
using art::Transform;

bool is_move(const Affine& affine)
{
    return affine.a == 1 && affine.b == 0 && affine.c == 0 && affine.d == 1;
}

bool is_upright(const Placement& placement) { return !placement.turns(); }

/// Whether x and y can be mixed with each other.
bool has_simple_place(const Transform& transform)
{
    return transform.path || transform.x.is_still() || transform.y.is_still() ||
           go_alike(transform.x, transform.y);
}

bool never_turns(const Transform& transform)
{
    return transform.rotate == Channel{0} && !is_skewed(transform);
}

bool turns_with_path(const Transform& transform) { return transform.path && transform.path->turns; }

bool can_take(const Affine& affine, const Transform& transform)
{
    if (is_move(affine))
        return true;
    const auto placement = placement_of(affine);
    if (!placement || !lies_flat(transform) || affine.determinant() == 0)
        return false;
    if (turns_with_path(transform) &&
        !(placement->is_even() && placement->scale_x > 0 && placement->scale_y > 0))
        return false;
    if (placement->is_even() && !placement->is_mirrored())
        return is_upright(*placement) || has_simple_place(transform);
    if (is_skewed(transform))
        return false;
    if (placement->is_even())
        return is_upright(*placement) || has_simple_place(transform);
    return is_upright(*placement) && never_turns(transform) && !transform.path;
}

/// Moves both coordinates at once, which have the same timing, or of which one is constant.
void move_place(const Affine& affine, Transform& transform)
{
    const Channel x = transform.x;
    const Channel y = transform.y;
    const auto mixed_from = [&](double of_x, double of_y, double offset) {
        if (of_y == 0)
            return shifted(scaled(x, of_x), offset);
        if (of_x == 0)
            return shifted(scaled(y, of_y), offset);
        return shifted(sum(scaled(x, of_x), scaled(y, of_y)), offset);
    };
    transform.x = mixed_from(affine.a, affine.c, affine.e);
    transform.y = mixed_from(affine.b, affine.d, affine.f);
}

void take(const Affine& affine, Transform& transform)
{
    if (transform.path)
        for (scene::Outline& outline : transform.path->path.outlines)
            outline = affine.of(outline);
    else
        move_place(affine, transform);
    if (is_move(affine))
        return;
    const Placement placement = *placement_of(affine);
    if (!turns_with_path(transform))
        transform.rotate =
            shifted(scaled(transform.rotate, placement.is_mirrored() ? -1 : 1), placement.rotate);
    transform.scale_x = scaled(transform.scale_x, placement.scale_x);
    transform.scale_y = scaled(transform.scale_y, placement.scale_y);
}

/// Dashes and trims are measured along what is drawn, before it is placed.
bool is_measured(const Shape& shape)
{
    return shape.trim || (shape.stroke && !shape.stroke->dashes.lengths.empty());
}

bool keeps_proportions(const Affine& affine)
{
    const auto placement = placement_of(affine);
    return placement && placement->is_even();
}

bool can_take(const Affine& affine, const Shape& shape)
{
    return !shape.skin && (!shape.stroke || affine.determinant() != 0) &&
           (!is_measured(shape) || keeps_proportions(affine));
}

void take(const Affine& affine, Shape& shape)
{
    for (auto& key : shape.drawing.keys)
        for (scene::Outline& outline : key.value.outlines)
            outline = affine.of(outline);
    if (shape.stroke)
        every_length(*shape.stroke, [factor = scale_factor_of(affine)](Channel& length) {
            length = scaled(length, factor);
        });
}

}

bool content_can_take(const Affine& affine, const Node& node)
{
    if (const auto* const shape = std::get_if<Shape>(&node.content))
        return can_take(affine, *shape);
    if (std::holds_alternative<art::Use>(node.content))
        return affine == Affine{};
    const auto can = [&](const Node& inner) { return can_take(affine, inner); };
    return std::ranges::all_of(std::get<Group>(node.content).nodes, can);
}

void content_takes(const Affine& affine, Node& node)
{
    if (auto* const shape = std::get_if<Shape>(&node.content))
        return take(affine, *shape);
    if (std::holds_alternative<art::Use>(node.content))
        return;
    for (Node& inner : std::get<Group>(node.content).nodes)
        take(affine, inner);
}

bool can_take(const Affine& affine, const Node& node)
{
    if (is_identity(node.transform) && content_can_take(affine, node))
        return true;
    if (!is_still(node.transform))
        return can_take(affine, node.transform);
    return placement_of(affine * matrix_at(node.transform, 0)).has_value();
}

void take(const Affine& affine, Node& node)
{
    if (is_identity(node.transform) && content_can_take(affine, node))
        content_takes(affine, node);
    else if (!is_still(node.transform))
        take(affine, node.transform);
    else
        node.transform = transform_of(*placement_of(affine * matrix_at(node.transform, 0)));
}

}
