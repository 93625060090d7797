#include "host/scene_text/arrange/skewing.hpp"

#include "host/art/document/matrix_at.hpp"
#include "host/scene_text/arrange/baking.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/sums.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace kfast::scene_text {
namespace {

using art::Affine;
using art::Channel;
using art::Group;
using art::Node;
using art::Transform;

/// The singular values and vectors of an affine map: it turns, grows along the axes, and turns again.
struct Rotations {
    double first = 0; ///< degrees
    double scale_x = 1;
    double scale_y = 1;
    double second = 0;
};

Rotations turns_of(const Affine& affine)
{
    const double sum_angle = std::atan2(affine.b - affine.c, affine.a + affine.d);
    const double difference_angle = std::atan2(affine.b + affine.c, affine.a - affine.d);
    const double sum = std::hypot(affine.a + affine.d, affine.b - affine.c) / 2;
    const double difference = std::hypot(affine.a - affine.d, affine.b + affine.c) / 2;
    constexpr double half_degrees = 90 / std::numbers::pi;
    return {(sum_angle - difference_angle) * half_degrees, sum + difference, sum - difference,
            (sum_angle + difference_angle) * half_degrees};
}

bool has_constant_skew(const Transform& transform)
{
    return transform.scale_x.is_still() && transform.scale_y.is_still() && transform.skew.is_still() &&
           transform.skew_axis.is_still();
}

/// Around the content, a group that turns it and then what it did, but leaning.
void make_two(Node& node)
{
    Transform& transform = node.transform;
    Transform shape = transform;
    shape.rotate = {0};
    const Rotations turns = turns_of(shape_at(shape, 0));
    Node inner{.name = {},
               .transform = {},
               .opacity = {1},
               .shown = std::vector{art::Span{}},
               .parent_tag = 0,
               .content = std::move(node.content)};
    inner.transform.rotate = {turns.first};
    inner.transform.anchor_x = std::exchange(transform.anchor_x, Channel{0});
    inner.transform.anchor_y = std::exchange(transform.anchor_y, Channel{0});
    transform.rotate = shifted(transform.rotate, turns.second);
    transform.scale_x = {turns.scale_x};
    transform.scale_y = {turns.scale_y};
    transform.skew = transform.skew_axis = {0};
    std::vector<Node> nodes;
    nodes.push_back(std::move(inner));
    node.content = Group{std::move(nodes)};
}

/// What leans is baked alone; what it does besides, outside of that, it goes on doing.
void bake_shape(Node& node, const Arranging& arranging)
{
    Transform outside = node.transform;
    Transform& shape = node.transform;
    shape.x = shape.y = shape.z = shape.rotate = shape.rotate_x = shape.rotate_y = {0};
    shape.path.reset();
    outside.anchor_x = outside.anchor_y = outside.skew = outside.skew_axis = {0};
    outside.scale_x = outside.scale_y = {1};
    bake(node, arranging);
    node.transform = outside;
}

}

void straighten(std::vector<Node>& nodes, const Arranging& arranging)
{
    for (Node& node : nodes) {
        if (is_skewed(node.transform) && has_constant_skew(node.transform))
            make_two(node);
        else if (is_skewed(node.transform))
            bake_shape(node, arranging);
        if (auto* const group = std::get_if<Group>(&node.content))
            straighten(group->nodes, arranging);
    }
}

}
