#include "core/scene_walk.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/scene/item_view.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

constexpr std::uint32_t opaque = 255;

}

SceneWalk::SceneWalk(const SceneOnPanel& on_panel, Opacity opacity)
    : on_panel_{on_panel}, opacity_{opacity}, top_{levels()}, current_{top_}
{
    *top_ = {.node = number_of(on_panel.prepared.root()), .has_space = true};
    begin_inside(*top_);
}

SceneWalk::Step SceneWalk::next()
{
    for (;;) {
        current_ = top_;
        if (std::exchange(top_->is_to_come, false))
            return Step::leaf;
        if (const Node* const node = next_in(*top_)) {
            const bool is_seen = enter(*node);
            current_ = top_;
            if (is_seen && top_->is_blended)
                return Step::begin_group;
            continue;
        }
        if (top_ == levels())
            return Step::end;
        --top_;
        if (current_->is_blended)
            return Step::end_group;
    }
}

/// Returns whether it is visible.
bool SceneWalk::enter(const Node& node)
{
    const WalkLevel& outer = *top_;
    const PreparedScene& prepared = on_panel_.prepared;
    const std::uint32_t path = path_to(node.place, outer.path);
    count_ops_for(path);
    count_op(Op::item);
    Dependence dependence = outer.dependence;
    for (const TrackState& track : prepared.tracks(node)) {
        const Dependence of_track = prepared.dependence(track);
        whole_ = whole_ | of_track;
        if (shapes_item(static_cast<Property>(track.property)))
            dependence = dependence | of_track;
    }
    const std::uint32_t own = ItemState{on_panel_.scene, prepared, node}.opacity();
    const std::uint32_t opacity = product_of_opacities(inner_opacity(outer), own);
    if (opacity == 0)
        return false;
    push(node, path, opacity, dependence);
    if (node.is_leaf()) {
        leaf_dependence_ = dependence | (node.kind == ItemKind::live ? prepared.dependence_of_input(node.of)
                                                                     : prepared.dependence_of_strokes(node));
        whole_ = whole_ | leaf_dependence_;
    }
    return true;
}

void SceneWalk::push(const Node& node, std::uint32_t path, std::uint32_t opacity,
                     const Dependence& dependence)
{
    const std::uint8_t placed_around = top_->placed;
    WalkLevel& level = *++top_;
    level.node = number_of(node);
    level.path = path;
    level.opacity = static_cast<std::uint8_t>(opacity);
    level.dependence = dependence;
    level.is_blended = opacity != opaque && opacity_ == Opacity::of_groups && node.has_several_layers;
    level.is_to_come = node.is_leaf();
    level.placed = static_cast<std::uint8_t>(placed_around + (node.is_placed ? 1 : 0));
    level.has_space = false;
    level.is_ordered = false;
    level.next = level.end = 0;
    if (!node.is_leaf())
        begin_inside(level);
}

void SceneWalk::begin_inside(WalkLevel& level) const
{
    const Node& inside = on_panel_.prepared.inside(node_of(level));
    level.first = static_cast<std::uint16_t>(number_of(inside) + 1);
    level.next = level.first;
    level.end = inside.end;
    level.is_ordered = inside.is_ordered;
    level.order = std::numeric_limits<std::int32_t>::min();
    level.next_order = no_order;
}

/// Null after the last one.
const Node* SceneWalk::next_in(WalkLevel& level) const
{
    if (level.is_ordered)
        return next_by_order(level);
    if (level.next == level.end)
        return nullptr;
    const Node& node = on_panel_.prepared.nodes()[level.next];
    level.next = node.end;
    return &node;
}

/// The lowest order first, and of equals the first: they are passed once for each order that they have at the
/// time.
const Node* SceneWalk::next_by_order(WalkLevel& level) const
{
    for (;;) {
        while (level.next != level.end) {
            const Node& node = on_panel_.prepared.nodes()[level.next];
            level.next = node.end;
            const std::int32_t order = order_of(node);
            if (order == level.order)
                return &node;
            if (order > level.order)
                level.next_order = std::min(level.next_order, order);
        }
        if (level.next_order == no_order)
            return nullptr;
        level.order = std::exchange(level.next_order, no_order);
        level.next = level.first;
    }
}

std::int32_t SceneWalk::order_of(const Node& node) const
{
    for (const TrackState& track : on_panel_.prepared.tracks(node))
        if (static_cast<Property>(track.property) == Property::order)
            return track.from;
    return 0;
}

const Space& SceneWalk::space()
{
    WalkLevel* level = current_;
    while (!level->has_space)
        --level;
    while (level != current_) {
        const Space& outer = space_of(*level++);
        level->has_space = true;
        if (const Node& node = node_of(*level); node.is_placed) {
            const ItemState state{on_panel_.scene, on_panel_.prepared, node};
            on_panel_.spaces[level->placed - 1U] =
                product(outer, state.placement(), on_panel_.scene.features());
        }
    }
    return space_of(*current_);
}

}
