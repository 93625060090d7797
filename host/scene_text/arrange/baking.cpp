#include "host/scene_text/arrange/baking.hpp"

#include "host/art/animation/baked_drawing.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/curves.hpp"
#include "host/program/failure.hpp"
#include "host/scene_text/arrange/arrange.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace kfast::scene_text {

namespace {

using art::Affine;
using art::Animated;
using art::Channel;
using art::Drawing;
using art::Node;
using art::Shape;

/// What acts on a node, over time, and the keys of it.
struct Action {
    std::function<Affine(double)> at;
    std::vector<double> critical;
    std::size_t depth = 0; ///< of nested transforms
};

template <typename Value>
void add_times(const Animated<Value>& animated, std::vector<double>& times)
{
    for (const auto& key : animated.keys)
        times.push_back(key.time);
}

art::Baking baking_of(std::vector<double> critical, double tolerance)
{
    const auto [first, last] = std::ranges::minmax(critical);
    return {.from = first, .to = last, .critical = std::move(critical), .tolerance = tolerance};
}

Drawing applied(const Affine& affine, const Drawing& drawing)
{
    Drawing result;
    for (const scene::Outline& outline : drawing.outlines)
        result.outlines.push_back(affine.of(outline));
    return result;
}

std::size_t point_count(const Drawing& drawing)
{
    std::size_t count = drawing.outlines.size();
    for (const scene::Outline& outline : drawing.outlines)
        count += outline.curves.size();
    return count;
}

class Bake {
public:
    explicit Bake(const Arranging& arranging) : arranging_{arranging} {}

    void node(Node& node, const Action& outer) const
    {
        const Action action = inside(node, outer);
        node.transform = {};
        if (auto* const group = std::get_if<art::Group>(&node.content))
            for (Node& inner : group->nodes)
                this->node(inner, action);
        else if (std::holds_alternative<art::Use>(node.content))
            throw Failure("\"" + node.name + "\" is used several times, in what leans or lies too deep");
        else
            shape(std::get<Shape>(node.content), node.name, action);
    }

private:
    Action inside(Node& node, const Action& outer) const
    {
        if (!lies_flat(node.transform))
            lose("turns in space, so deep inside of groups", node.name, "it stays flat");
        Action action = outer;
        ++action.depth;
        art::every_animation(node.transform,
                             [&](const auto& animated) { add_times(animated, action.critical); });
        action.at = [outer_at = outer.at, own = node.transform](double time) {
            return outer_at(time) * matrix_at(own, time);
        };
        return action;
    }

    void shape(Shape& shape, const std::string& name, const Action& action) const
    {
        if (shape.skin)
            return lose("a figure that bones carry, so deep inside of groups", name,
                        "it stays where it is drawn");
        if (shape.stroke)
            every_length(*shape.stroke, [&](Channel& length) { bake_length(length, action); });
        bake_drawing(shape.drawing, name, action);
    }

    void bake_length(Channel& length, const Action& action) const
    {
        if (length == Channel{0})
            return;
        std::vector<double> critical = action.critical;
        add_times(length, critical);
        length = art::baked_channel(
            [&, given = length](double time) {
                arranging_.budget.take_computed_points(action.depth);
                return given.at(time) * scale_factor_of(action.at(time));
            },
            baking_of(std::move(critical), arranging_.tolerance));
    }

    void bake_drawing(Animated<Drawing>& drawing, const std::string& name, const Action& action) const
    {
        const auto has_form = [&](const auto& key) {
            return same_form(key.value, drawing.keys.front().value);
        };
        if (!std::ranges::all_of(drawing.keys, has_form)) {
            lose("drawings of several forms, so deep inside of groups", name,
                 "they move straight from key to key");
            for (auto& key : drawing.keys)
                key.value = applied(action.at(key.time), key.value);
            return;
        }
        std::vector<double> critical = action.critical;
        add_times(drawing, critical);
        drawing = art::baked_drawing(
            [&, points = point_count(drawing.keys.front().value), given = drawing](double time) {
                arranging_.budget.take_computed_points(points + action.depth);
                return applied(action.at(time), given.at(time));
            },
            baking_of(std::move(critical), arranging_.tolerance));
    }

    void lose(std::string feature, const std::string& layer, std::string instead) const
    {
        arranging_.losses.add({std::move(feature), layer, {}, std::move(instead)});
    }

    const Arranging& arranging_;
};

}

void bake(Node& node, const Arranging& arranging)
{
    Bake{arranging}.node(node, {[](double) { return Affine{}; }, {}, 0});
}

namespace {

using art::Group;
using art::Transform;

/// The singular value decomposition of an affine map: it rotates, scales along the axes, and rotates again.
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

/// Puts the content into a node that rotates it, inside of what the node did before, without the skew.
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

/// Bakes skew, scale and anchor alone; what the node does outside of that stays a transform.
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
