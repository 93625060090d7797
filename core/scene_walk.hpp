#pragma once

#include "core/math/projection.hpp"
#include "core/pose/item_state.hpp"
#include "core/pose/scene_state.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace kfast {

/// Walks through what is visible in a scene at a time, in the order of painting: leaves, and where groups,
/// uses and leaves that are blended as a whole begin and end.
///
///     root ┬ sky                            leaf sky
///          ├ bird (opacity 128) ┬ body      begin_group, leaf body, leaf wing, end_group
///          │                    └ wing
///          └ hidden (opacity 0) ─ ...
class SceneWalk {
public:
    enum class Step : std::uint8_t { leaf, begin_group, end_group, end };
    /// What opacities of groups apply to: their finished pictures, or each leaf inside.
    enum class Opacity : std::uint8_t { of_groups, of_leaves };

    /// `on_panel` has been moved to a time; it must outlive the walk, which uses its room for levels and
    /// spaces.
    SceneWalk(const SceneOnPanel& on_panel, Opacity opacity);

    Step next();

    // About the item of the last step.

    const Node& node() const { return node_of(*current_); }
    ItemState state() const { return {on_panel_.scene, on_panel_.prepared, node()}; }
    /// Identifies the item (core/scene/item_view.hpp).
    std::uint32_t path() const { return current_->path; }
    /// The opacity that applies to the colours of a leaf.
    std::uint32_t leaf_opacity() const { return inner_opacity(*current_); }
    /// The opacity that applies to the picture of a group, or of a leaf that is blended as one.
    std::uint32_t group_opacity() const { return current_->opacity; }
    /// What its place depends on: what moves it as a whole or widens it, its tracks and those around it.
    const Dependence& place_dependence() const { return current_->dependence; }
    /// For a leaf: what its place depends on, and what bends it.
    const Dependence& leaf_dependence() const { return leaf_dependence_; }
    /// From its own coordinates to the panel; computed when it is first asked for.
    const Space& space();
    /// The item and the groups and uses around it, the outermost first: the one of the level 0 … depth() - 1.
    const Node& node(std::size_t level) const { return node_of(levels()[level + 1]); }
    std::size_t depth() const { return static_cast<std::size_t>(current_ - levels()); }

    /// What the whole picture depends on, as far as it was walked through: all tracks of what is visible, and
    /// of what is not those that could show it.
    const Dependence& whole() const { return whole_; }

private:
    static constexpr std::int32_t no_order = std::numeric_limits<std::int32_t>::max();

    /// The opacity that applies to the colours of what is within it.
    static std::uint32_t inner_opacity(const WalkLevel& level)
    {
        return level.is_blended ? 255 : level.opacity;
    }
    WalkLevel* levels() const { return on_panel_.prepared.levels().data(); }
    const Node& node_of(const WalkLevel& level) const { return on_panel_.prepared.nodes()[level.node]; }
    const Space& space_of(const WalkLevel& level) const
    {
        return level.placed == 0 ? on_panel_.canvas : on_panel_.spaces[level.placed - 1U];
    }
    const Node* next_in(WalkLevel& level) const;
    const Node* next_by_order(WalkLevel& level) const;
    std::int32_t order_of(const Node& node) const;
    bool enter(const Node& node);
    void push(const Node& node, std::uint32_t path, std::uint32_t opacity, const Dependence& dependence);
    void begin_inside(WalkLevel& level) const;
    std::uint16_t number_of(const Node& node) const
    {
        return static_cast<std::uint16_t>(&node - on_panel_.prepared.nodes().data());
    }

    const SceneOnPanel& on_panel_;
    Opacity opacity_;
    WalkLevel* top_;
    WalkLevel* current_;
    Dependence leaf_dependence_;
    Dependence whole_;
};

}
