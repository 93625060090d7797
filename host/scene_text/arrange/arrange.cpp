#include "host/scene_text/arrange/arrange.hpp"

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene_text/arrange/baking.hpp"
#include "host/scene_text/arrange/passes.hpp"
#include "host/scene_text/arrange/placement.hpp"
#include "host/scene_text/values/stored_keys.hpp"
#include "host/scene_text/values/sums.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace kfast::scene_text {

namespace {

using art::Channel;
using art::Group;
using art::Node;

bool is_plain(const Node& node)
{
    return std::holds_alternative<Group>(node.content) && is_identity(node.transform) &&
           node.opacity == Channel{1} && node.shown == std::vector{art::Span{}};
}

/// Replaces groups by their nodes.
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

    /// The depth of nested groups and uses; copies are in a group of their own.
    int of(const std::vector<Node>& nodes) const
    {
        int depth = 0;
        for (const Node& node : nodes)
            if (const auto* const group = std::get_if<Group>(&node.content))
                depth = std::max(depth, 1 + of(group->nodes));
            else if (const auto* const use = std::get_if<art::Use>(&node.content))
                depth =
                    std::max(depth, (use->copies.count > 1 ? 2 : 1) + arranging_.symbols[use->symbol].depth);
        return depth;
    }

    /// `room` is how deeply groups may be nested here.
    void limit(std::vector<Node>& nodes, int room)
    {
        if (of(nodes) <= room)
            return;
        for (Node& node : nodes)
            if (auto* const group = std::get_if<Group>(&node.content))
                limit(group->nodes, std::max(room - 1, 0));
        // Groups that are only names go first.
        dissolve(nodes, [&](const Node& node) { return is_plain(node) && too_deep(node, room); });
        if (of(nodes) <= room)
            return;
        for (Node& node : nodes)
            if (std::holds_alternative<Group>(node.content) && too_deep(node, room))
                flatten(node);
        dissolve(nodes, [&](const Node& node) { return is_plain(node) && too_deep(node, room); });
    }

private:
    bool too_deep(const Node& node, int room) const
    {
        const auto* const group = std::get_if<Group>(&node.content);
        return group != nullptr && 1 + of(group->nodes) > room;
    }

    /// Moves what the group does into its nodes.
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

/// Limits the nesting of groups to what scenes hold: those beyond are dissolved, and what they do is
/// baked.
void limit_depth(std::vector<Node>& nodes, const Arranging& arranging)
{
    Depth{arranging}.limit(nodes, scene::deepest_item);
}

using art::Affine;

constexpr double min = 0.05;
/// The maximum number of sampled times for each shape.
constexpr std::size_t max_times = 64;

void add_times(const art::Transform& transform, std::vector<double>& times)
{
    for (const art::Channel* channel :
         {&transform.scale_x, &transform.scale_y, &transform.skew, &transform.rotate})
        for (const auto& key : channel->keys)
            if (times.size() < max_times)
                times.push_back(key.time);
}

class Pens {
public:
    explicit Pens(const Arranging& arranging) : arranging_{arranging} {}

    void look_at(const std::vector<Node>& nodes)
    {
        for (const Node& node : nodes) {
            around_.push_back(&node);
            if (const auto* const group = std::get_if<art::Group>(&node.content))
                look_at(group->nodes);
            else if (has_line_itself(node))
                look_at_line();
            around_.pop_back();
        }
    }

private:
    bool has_line_itself(const Node& node) const
    {
        if (const auto* const use = std::get_if<art::Use>(&node.content))
            return arranging_.symbols[use->symbol].has_line;
        return std::get<art::Shape>(node.content).stroke.has_value();
    }

    /// Checks the line of the innermost node.
    void look_at_line()
    {
        std::vector<double> times;
        for (const Node* node : around_)
            add_times(node->transform, times);
        std::ranges::sort(times);
        const auto bent =
            std::ranges::find_if(times, [this](double time) { return distortion_of(shape(time)) > min; });
        if (bent == times.end())
            return;
        const bool is_later = *bent > times.front();
        arranging_.losses.add({"a line that becomes wider one way than the other", names(),
                               is_later ? std::optional{*bent} : std::nullopt,
                               "it is as wide in every direction"});
    }

    Affine shape(double time) const
    {
        Affine shape;
        for (const Node* node : around_)
            shape = shape * shape_at(node->transform, time);
        return shape;
    }

    std::string names() const
    {
        std::string names;
        for (const Node* node : around_)
            if (!node->name.empty())
                names += (names.empty() ? "" : " / ") + node->name;
        return names;
    }

    const Arranging& arranging_;
    std::vector<const Node*> around_ = {}; ///< from the outermost
};

/// Lines of scenes are equally wide in all directions: reports those whose pen becomes wider one way than the
/// other, by more than a twentieth, because what is around them is scaled unevenly or skewed.
void report_bent_pens(const std::vector<Node>& nodes, const Arranging& arranging)
{
    Pens{arranging}.look_at(nodes);
}

Reach arrange(std::vector<Node>& nodes, const Arranging& arranging)
{
    join_parts(nodes);
    drop_unseen(nodes, arranging);
    report_bent_pens(nodes, arranging);
    part_paints(nodes, arranging.length);
    fold(nodes);
    straighten(nodes, arranging);
    fold(nodes);
    centre_uses(nodes, arranging);
    Reach reach;
    reach.left_alone = fit_ranges(nodes);
    limit_depth(nodes, arranging);
    reach.in_groups = hold_in_ranges(nodes, arranging.losses);
    return reach;
}

bool has_line(const std::vector<Node>& nodes, const Arranging& arranging)
{
    return std::ranges::any_of(nodes, [&](const Node& node) {
        if (const auto* const group = std::get_if<Group>(&node.content))
            return has_line(group->nodes, arranging);
        if (const auto* const use = std::get_if<art::Use>(&node.content))
            return arranging.symbols[use->symbol].has_line;
        return std::get<art::Shape>(node.content).stroke.has_value();
    });
}

art::Extent extent_of(const std::vector<Node>& nodes, const Arranging& arranging)
{
    art::Extent all;
    for (const Node& node : nodes) {
        art::Extent content;
        if (const auto* const group = std::get_if<Group>(&node.content))
            content = extent_of(group->nodes, arranging);
        else if (const auto* const use = std::get_if<art::Use>(&node.content))
            content = copied(arranging.symbols[use->symbol].extent, use->copies);
        else
            content = art::extent_of(std::get<art::Shape>(node.content), {});
        all.take(placed(content, node.transform));
    }
    return all;
}

ArrangedSymbol arranged(const art::Symbol& symbol, const Arranging& arranging)
{
    return {!symbol.nodes.empty(), has_line(symbol.nodes, arranging), Depth{arranging}.of(symbol.nodes),
            extent_of(symbol.nodes, arranging)};
}

}

Reach arrange(art::Document& document, Arranging arranging)
{
    draw_symbols_larger(document);
    Reach reach;
    const std::int32_t length = arranging.length;
    for (art::Symbol& symbol : document.symbols) {
        arranging.length = length_of(symbol);
        reach.take(arrange(symbol.nodes, arranging));
        arranging.symbols.push_back(arranged(symbol, arranging));
    }
    arranging.length = length;
    reach.take(arrange(document.nodes, arranging));
    return reach;
}

}
