#pragma once

#include "core/canvas_map.hpp"
#include "core/carried_drawing.hpp"
#include "core/coverage_row.hpp"
#include "core/edge_list.hpp"
#include "core/item_state.hpp"
#include "core/key_interval.hpp"
#include "core/live_backbones.hpp"
#include "core/live_bones.hpp"
#include "core/object_outline.hpp"
#include "core/paint_step.hpp"
#include "core/pixel_format.hpp"
#include "core/projection.hpp"
#include "core/result.hpp"
#include "core/scene_view.hpp"
#include "core/size.hpp"
#include "core/stroke_outline.hpp"
#include "core/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Draws any moment of a scene, rows from the top down, in memory that the caller lends.
///
/// The picture depends on scene, time, fit and panel size alone: not on earlier pictures, nor on how its rows
/// are divided into bands.
///
/// Besides the block it takes up to 8.5 KB of stack (docs/design.md, "The bound on memory").
class Player {
public:
    /// The sides of a panel are 1 … max_panel pixels long.
    static constexpr int max_panel = 4096;

    /// Bytes that create() must be lent: enough for every time of the scene.
    static std::size_t block_bytes(const SceneView& scene, Size panel);

    /// `scene`'s bytes and `block` (aligned to 4 bytes) must outlive the player. Fails with block_too_small.
    static Result<Player> create(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block);

    /// Computes the outlines of the picture at `time`. Any time is allowed: the scene's loop mode decides
    /// what it stands for.
    void show(Time time);
    /// As show(), but without loop: the scene's beginning before it and its very end from there on.
    void show_moment(Time moment);

    /// Draws the next `rows` rows of the picture into `pixels`, rows x row_bytes(format, panel width) bytes.
    /// The first call after show() begins at row 0. No more rows than the panel has.
    template <PixelFormat format>
    void draw_rows(int rows, std::span<std::byte> pixels);

    const SceneView& scene() const { return scene_; }
    Size panel() const { return panel_; }
    /// Edges of the picture that is shown; those that found no room counted too.
    std::size_t edge_count() const { return edges_.count(); }
    /// Steps in which its rows are painted; at most the scene's paint_steps().
    std::size_t step_count() const { return step_count_; }

private:
    Player(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block);

    void trace(ItemCursor items, const Space& space);
    void trace(const ItemView& item, const Space& space);
    void trace(const ItemView& item, const ItemState& state, std::uint32_t opacity, const Space& space);
    void trace_object(const ObjectView& object, const ItemState& state, std::uint32_t opacity,
                      const Space& placement);
    void trace_strokes(const ObjectView& object, const KeyInterval<Key>& keys, const Affine& placement,
                       ObjectOutline& outline);
    CarriedDrawing carried(const ObjectView& object, std::uint32_t drawing, std::uint32_t skin) const;
    LiveBackbones backbones_of(const ObjectView& object) const;
    Point first_point(const ObjectView& object, const Key& key) const;
    PaintStep& add_step(PaintStep::Kind kind);
    Layer& add_layer(Colour colour, std::uint32_t opacity, FillRule rule);

    template <class Row>
    void draw_row(Row row, std::size_t bytes);
    template <class Row>
    void paint_layer(Row row, Layer& layer);
    std::span<std::byte> backdrop(std::size_t depth);

    SceneView scene_;
    Size panel_;
    Space canvas_; ///< from the canvas to the panel
    Camera camera_;
    Time moment_;
    std::span<LiveBone> bones_; ///< of all skeletons
    std::span<BackboneNode> backbone_nodes_;
    std::span<PaintStep> steps_;
    std::size_t step_count_ = 0;
    EdgeList edges_;
    CoverageRow coverage_;
    std::span<std::byte> backdrops_; ///< a row of the panel for each depth of blending
    int next_row_ = 0;
};

extern template void Player::draw_rows<PixelFormat::rgb565>(int rows, std::span<std::byte> pixels);
extern template void Player::draw_rows<PixelFormat::grey4>(int rows, std::span<std::byte> pixels);
extern template void Player::draw_rows<PixelFormat::mono1>(int rows, std::span<std::byte> pixels);

}
