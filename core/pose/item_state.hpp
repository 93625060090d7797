#pragma once

#include "core/math/affine.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/raster/outline/contour_cache.hpp"
#include "core/scene/scene_view.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// How something lies on the panel that is only moved, turned, grown, and maybe mirrored: it is outlined at
/// one of a few scales, upright, and its corners are placed from there.
struct RigidPlacement {
    std::int8_t scale_bits = 0; ///< the scale is that of the canvas, times 2^scale_bits
    std::int32_t scale = 0;     ///< Q16, in all
    raster::CornerMap map;

    Affine upright() const { return {.xx = scale, .yy = scale}; }
};

/// Finds them on one panel.
class RigidPlacements {
public:
    /// `canvas_scale` is that from the canvas to the panel, Q16.
    explicit RigidPlacements(std::int32_t canvas_scale = Fixed::one);

    /// Of a map to the panel; none if it shears or squashes, or goes far beyond what is usual.
    ///
    /// The scale is the least that is no less than 16/17 of what the map grows by: outlines are no coarser
    /// than if they were made in their place, and stay the same as long as that stays in its octave.
    std::optional<RigidPlacement> of(const Affine& map) const;

private:
    static constexpr int max_scale_bits = 4; ///< up or down

    /// In the place of one of the map, Q14, and for the scale of the canvas.
    std::int32_t factor(std::int32_t q16) const;

    std::int32_t base_;    ///< the scale of the canvas, so that 2^-max_scale_bits of it is whole
    std::int64_t inverse_; ///< of it, in 2^-(16 + inverse_bits)
};

/// What the tracks of an item come to at the moment of a prepared scene.
class ItemState {
public:
    /// All must outlive it.
    ItemState(const SceneView& scene, const PreparedScene& prepared, const Node& item)
        : scene_{scene}, prepared_{prepared}, item_{item}
    {
    }

    /// 0 … 255; 0 if the item is not to be seen at all.
    std::uint32_t opacity() const;
    /// From the item's own space to that of what it lies in.
    Space placement() const;
    Point pivot() const;
    /// Only of what is filled.
    Colour fill() const { return colour(Property::fill, item_.style.fill); }
    /// Only of what is stroked.
    Colour stroke() const { return colour(Property::stroke, item_.style.stroke); }
    /// Of the stroke; likewise.
    Fixed width() const;

private:
    const TrackState* track(Property property) const;
    std::int32_t fine(Property property) const;
    Colour colour(Property property, std::uint8_t without_track) const;

    const SceneView& scene_;
    const PreparedScene& prepared_;
    const Node& item_;
};

}
