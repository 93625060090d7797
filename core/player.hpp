#pragma once

#include "core/bytes/result.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "core/pose/scene_state.hpp"
#include "core/raster/dirty.hpp"
#include "core/raster/renderer.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

using raster::Change;

/// Draws a scene at any time, rows from the top down, in memory that the caller lends.
///
/// The picture depends on scene, time, inputs, fit and panel size alone: not on earlier pictures, nor on how
/// its rows are divided into bands or areas.
class Player : public SceneState {
public:
    /// The sides of a panel are 1 … max_panel pixels long.
    static constexpr int max_panel = 4096;

    /// Bytes that create() must be lent: enough for every time of the scene.
    static std::size_t block_bytes(const SceneView& scene, Size panel);

    /// `scene`'s bytes and `block` (aligned to 4 bytes) must outlive the player, which must not be moved
    /// once it has drawn. Fails with block_too_small.
    static Result<Player> create(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block);

    /// As create(), but `block` has block_bytes(), no more and no less.
    [[gnu::cold, gnu::noinline]] Player(const SceneView& scene, Size panel, Fit fit,
                                        std::span<std::byte> block);

    /// Computes the outlines of the picture at `time`. Any time is allowed: the scene's loop mode decides
    /// what it represents.
    void show(Time time);
    /// As show(), but without loop: the scene's beginning before it and its very end from there on.
    void show_moment(Time moment);

    /// Draws the next `rows` rows of the picture into `pixels`, rows x row_bytes(format, panel width) bytes.
    /// `pixels` is aligned to 2 if pixels are 16 bits (a Cortex-M0 faults otherwise). The first call after
    /// show() begins at row 0. No more rows than the panel has.
    template <PixelFormat format>
    void draw_rows(int rows, std::span<std::byte> pixels);

    /// Draws the next areas in which the picture differs from the last one that was drawn in this way, as
    /// many as find room in `pixels`, which has room for granularity.height whole rows and is aligned as for
    /// draw_rows(); none when all is drawn. At first, and after redraw(), that is the whole panel. Positions
    /// and sizes of areas are multiples of `granularity`, which holds whole bytes, except that an area may
    /// end with the panel; `area_bytes` is what each area costs besides its pixels. The result is valid until
    /// the next call.
    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int area_bytes);
    /// From now on, what the panel shows is not known.
    void redraw();

    Size panel() const { return panel_; }
    /// The picture that show() has computed.
    const raster::Picture& picture() const { return renderer_.picture(); }
    /// Whether, for want of room in the block, its curves are coarser, or parts of it are missing.
    bool is_coarse() const { return picture().is_coarse(); }
    /// The number of bands of rows of which it is not known what the panel shows, once draw_changes() has
    /// drawn it: for want of room, they are drawn whole the next time.
    int unrecorded_bands() const { return renderer_.unrecorded_bands(); }

private:
    void trace();

    Size panel_;
    raster::Renderer renderer_;
    int next_row_ = 0; ///< of draw_rows()
};

#define KFAST_INSTANTIATED(name, bits)                                                                       \
    extern template void Player::draw_rows<PixelFormat::name>(int, std::span<std::byte>);                    \
    extern template std::span<const Change> Player::draw_changes<PixelFormat::name>(std::span<std::byte>,    \
                                                                                    Size, int);
KFAST_PIXEL_FORMATS(KFAST_INSTANTIATED)
#undef KFAST_INSTANTIATED

}
