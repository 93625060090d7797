#include "host/scene_text/arrange/passes.hpp"

#include "host/scene_text/arrange/carrying.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/grid.hpp"
#include "host/scene_text/values/reach.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kfast::scene_text {
namespace {

using art::Channel;
using art::Group;
using art::Node;
using art::Shape;
using art::Transform;

/// From this scale on, the rounding to 1/16 px is visible.
constexpr double coarse_scale = 2;

double largest(const Channel& channel)
{
    double max = 0;
    for (const auto& key : channel.keys)
        max = std::max(max, std::abs(key.value));
    return max;
}

double reach_of(scene::Vec2 spot) { return std::max(std::abs(spot.x), std::abs(spot.y)); }

double reach_of(const art::Drawing& drawing)
{
    double reach = 0;
    for (const scene::Outline& outline : drawing.outlines) {
        reach = std::max(reach, reach_of(outline.from));
        for (const scene::Curve& curve : outline.curves) {
            reach = std::max(reach, reach_of(curve.to));
            if (curve.cubic)
                reach = std::max({reach, reach_of(curve.c1), reach_of(curve.c2)});
        }
    }
    return reach;
}

double reach_of(const Node& node)
{
    double reach = std::max(largest(node.transform.anchor_x), largest(node.transform.anchor_y));
    if (const auto* const shape = std::get_if<Shape>(&node.content))
        for (const auto& key : shape->drawing.keys)
            reach = std::max(reach, reach_of(key.value));
    return reach;
}

/// The largest distance at any two times: positions are written as offsets from where the anchor is.
double farthest(const Channel& channel, const Channel& other)
{
    const auto range = [](const Channel& of) {
        const auto [low, high] = std::ranges::minmax(of.keys, {}, &art::Key<double>::value);
        return std::pair{low.value, high.value};
    };
    const auto [low, high] = range(channel);
    const auto [other_low, other_high] = range(other);
    return std::max(std::abs(high - other_low), std::abs(other_high - low));
}

double distance_of(const Transform& transform)
{
    if (transform.path)
        return reach_of(transform.path->path);
    return std::max(farthest(transform.x, transform.anchor_x), farthest(transform.y, transform.anchor_y));
}

/// At any key.
double longest_period(const art::Dashes& dashes)
{
    double longest = 0;
    for (const Channel& length : dashes.lengths)
        for (const auto& key : length.keys)
            longest = std::max(longest, period_at(dashes, key.time));
    return longest;
}

/// The power of two that brings `reach` within bounds.
double shrink_for(double reach) { return std::exp2(std::ceil(std::log2(reach / widest_reach))); }

class Ranges {
public:
    /// Without `losses`, new groups may be added.
    explicit Ranges(art::Losses* losses) : losses_{losses} {}

    /// Returns the greatest coordinate.
    double fit(std::vector<Node>& nodes)
    {
        for (Node& node : nodes)
            fit(node);
        return reach_;
    }

private:
    void fit(Node& node)
    {
        const double scale = std::max(largest(node.transform.scale_x), largest(node.transform.scale_y));
        if (scale > coarse_scale && reach_of(node) * scale < widest_reach)
            draw_larger(node, scale);
        if (const double reach = reach_of(node); reach > widest_reach)
            draw_larger(node, 1 / shrink_for(reach));
        unwind(node.transform.rotate);
        if (auto* const group = std::get_if<Group>(&node.content))
            fit(group->nodes);
        const double distance = distance_of(node.transform);
        reach_ = std::max({reach_, reach_of(node), distance});
        if (losses_ != nullptr) {
            if (auto* const shape = std::get_if<Shape>(&node.content); shape != nullptr && shape->stroke)
                reduce_offset(shape->stroke->dashes);
            check(node);
            drop_fine_dashes(node);
        } else if (distance > widest_reach)
            go_further(node, shrink_for(distance));
    }

    /// Scales the content up by `factor`, and the node down by it.
    static void draw_larger(Node& node, double factor)
    {
        const art::Affine scaling = art::grown(factor, factor);
        if (!content_can_take(scaling, node))
            return;
        content_takes(scaling, node);
        Transform& transform = node.transform;
        transform.anchor_x = scaled(transform.anchor_x, factor);
        transform.anchor_y = scaled(transform.anchor_y, factor);
        transform.scale_x = scaled(transform.scale_x, 1 / factor);
        transform.scale_y = scaled(transform.scale_y, 1 / factor);
    }

    /// Drops whole turns that all angles have in common.
    static void unwind(Channel& rotate)
    {
        const auto [low, high] = std::ranges::minmax(rotate.keys, {}, &art::Key<double>::value);
        if (largest(rotate) > degrees.high && high.value - low.value <= 2 * degrees.high - 360)
            rotate = shifted(rotate, -360 * std::round((low.value + high.value) / 720));
    }

    /// Puts the node into a group that is scaled by `factor`.
    static void go_further(Node& node, double factor)
    {
        if (!lies_flat(node.transform))
            return;
        const art::Affine scaling = art::grown(1 / factor, 1 / factor);
        if (!can_take(scaling, node))
            return;
        Node outer{.name = {},
                   .transform = transform_of({0, 0, 0, factor, factor}),
                   .opacity = {1},
                   .shown = std::vector{art::Span{}},
                   .parent_tag = 0,
                   .content = Group{}};
        take(scaling, node);
        std::get<Group>(outer.content).nodes.push_back(std::move(node));
        node = std::move(outer);
    }

    void check(const Node& node) const
    {
        const Transform& transform = node.transform;
        const auto exceeds = [](const Channel& channel, const Grid& grid) {
            return largest(channel) > grid.high;
        };
        if (exceeds(transform.scale_x, scales) || exceeds(transform.scale_y, scales))
            lose("growth by more than 64", node);
        if (exceeds(transform.rotate, degrees) || exceeds(transform.rotate_x, degrees) ||
            exceeds(transform.rotate_y, degrees))
            lose("more than 16 turns", node);
        if (reach_of(node) > coordinates.high || distance_of(transform) > coordinates.high ||
            exceeds(transform.z, coordinates))
            lose("coordinates beyond 2047 px", node);
        const auto* const shape = std::get_if<Shape>(&node.content);
        if (shape != nullptr && shape->stroke && exceeds(shape->stroke->width, widths))
            lose("a line wider than 4095 px", node);
        if (shape != nullptr && shape->stroke && exceeds(shape->stroke->dashes.offset, dash_offsets))
            lose("an offset of dashes beyond 16384 px", node);
    }

    /// Patterns that are as good as an even line all the time, and would be more dashes than a player draws.
    void drop_fine_dashes(Node& node) const
    {
        auto* const shape = std::get_if<Shape>(&node.content);
        if (shape == nullptr || !shape->stroke || shape->stroke->dashes.lengths.empty())
            return;
        if (longest_period(shape->stroke->dashes) >= art::Dashes::finest_period)
            return;
        shape->stroke->dashes = {};
        losses_->add({"dashes and gaps shorter than 1/4 px together", node.name, {}, "a whole line"});
    }

    void lose(std::string feature, const Node& node) const
    {
        losses_->add({std::move(feature), node.name, {}, "it is held at that"});
    }

    art::Losses* losses_;
    double reach_ = 0;
};

}

double fit_ranges(std::vector<Node>& nodes) { return Ranges{nullptr}.fit(nodes); }

double hold_in_ranges(std::vector<Node>& nodes, art::Losses& losses) { return Ranges{&losses}.fit(nodes); }

}
