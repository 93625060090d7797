#pragma once

#include "core/dependence.hpp"
#include "core/evaluator/node.hpp"
#include "core/evaluator/prepared_scene.hpp"
#include "core/item_state.hpp"
#include "core/kfb_limits.hpp"
#include "core/scene_on_panel.hpp"
#include "core/space.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace kfast {

/// Walks through what is seen of a scene at a moment, in the order of painting: leaves, and where groups,
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

    /// `on_panel` has been moved to a moment; it must outlive the walk, which uses its room for spaces.
    SceneWalk(const SceneOnPanel& on_panel, Opacity opacity);

    Step next();

    // Of what the last step was about.

    const Node& node() const { return *current_->node; }
    ItemState state() const { return {on_panel_.scene, on_panel_.prepared, node()}; }
    /// Tells it apart (core/item_path.hpp).
    std::uint32_t path() const { return current_->path; }
    /// What applies to the colours of a leaf.
    std::uint32_t leaf_opacity() const { return inner_opacity(*current_); }
    /// What applies to the picture of a group, or of a leaf that is blended as one.
    std::uint32_t group_opacity() const { return current_->opacity; }
    /// What moves it as a whole or widens it: its tracks and those around it.
    const Dependence& place_dependence() const { return current_->dependence; }
    /// Of a leaf: likewise, and what bends it.
    const Dependence& leaf_dependence() const { return leaf_dependence_; }
    /// From its own coordinates to the panel; computed when it is first asked for.
    const Space& space();
    /// It and the groups and uses around it, the outermost first: that of the level 0 … depth() - 1.
    const Node& node(std::size_t level) const { return *levels_[level + 1].node; }
    std::size_t depth() const { return static_cast<std::size_t>(current_ - levels_.data()); }

    /// On what the whole picture depends, as far as it was walked through: all tracks of what is seen, and of
    /// what is not those that could show it.
    const Dependence& whole() const { return whole_; }

private:
    /// A node on the way from the scene to the present one.
    struct Level {
        const Node* node = nullptr;
        std::uint16_t first = 0; ///< nodes that lie within it
        std::uint16_t next = 0;
        std::uint16_t end = 0;
        bool is_ordered = false;     ///< some of them have an order
        bool is_blended = false;     ///< as a whole
        bool is_to_come = false;     ///< a leaf that was not told yet
        std::uint8_t placed = 0;     ///< so many have spaces of their own, it and those around it
        std::int32_t order = 0;      ///< of the nodes that are passed now
        std::int32_t next_order = 0; ///< the lowest above it, of those passed
        std::uint32_t path = 0;
        std::uint32_t opacity = 255; ///< of its picture if it is blended, else of all that lies within it
        Dependence dependence;
        const Space* space = nullptr; ///< its own, or that of what lies around; null until it is computed
    };

    static constexpr std::size_t max_levels = kfb::max_depth + 2; ///< the scene, groups and uses, a leaf
    static constexpr std::int32_t no_order = std::numeric_limits<std::int32_t>::max();

    /// What applies to the colours of what lies within it.
    static std::uint32_t inner_opacity(const Level& level) { return level.is_blended ? 255 : level.opacity; }
    const Node* next_in(Level& level) const;
    const Node* next_by_order(Level& level) const;
    std::int32_t order_of(const Node& node) const;
    bool enter(const Node& node);
    void push(const Node& node, std::uint32_t path, std::uint32_t opacity, const Dependence& dependence);
    void begin_inside(Level& level) const;
    std::uint32_t number_of(const Node& node) const
    {
        return static_cast<std::uint32_t>(&node - on_panel_.prepared.nodes().data());
    }

    const SceneOnPanel& on_panel_;
    Opacity opacity_;
    std::array<Level, max_levels> levels_;
    Level* top_ = levels_.data();
    Level* current_ = levels_.data();
    Dependence leaf_dependence_;
    Dependence whole_;
};

}
