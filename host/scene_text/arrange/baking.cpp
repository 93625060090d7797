#include "host/scene_text/arrange/baking.hpp"

#include "host/art/animation/baked_drawing.hpp"
#include "host/art/document/every_animation.hpp"
#include "host/art/document/matrix_at.hpp"
#include "host/art/geometry/curve_length.hpp"
#include "host/scene_text/arrange/arrange.hpp"
#include "host/scene_text/arrange/placement.hpp"

#include <algorithm>
#include <functional>
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
    std::size_t depth = 0; ///< of transforms in each other
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
            bake_width(shape.stroke->width, action);
        bake_drawing(shape.drawing, name, action);
    }

    void bake_width(Channel& width, const Action& action) const
    {
        std::vector<double> critical = action.critical;
        add_times(width, critical);
        width = art::baked_channel(
            [&, given = width](double time) {
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

}
