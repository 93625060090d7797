#pragma once

#include "core/math/affine.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/raster/outline/contour_cache.hpp"
#include "core/scene/scene_view.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// How something is placed on the panel that is only moved, rotated, scaled, and maybe mirrored: it is
/// outlined at one of a few scales, upright, and its corners are placed from there.
struct RigidPlacement {
    std::int8_t scale_bits = 0; ///< the scale is that of the canvas, times 2^scale_bits
    std::int32_t scale = 0;     ///< Q16, total
    raster::CornerMap map;

    Affine upright() const { return {.xx = scale, .yy = scale}; }
};

/// Finds rigid placements on one panel.
class RigidPlacements {
public:
    /// `canvas_scale` is the scale from the canvas to the panel, Q16.
    explicit RigidPlacements(std::int32_t canvas_scale = Fixed::one);

    /// The placement by a map to the panel; none if it shears or squashes, or its scale is extreme.
    ///
    /// The scale is the smallest that is at least 16/17 of the scale of the map: outlines are no coarser
    /// than if they were made in place, and stay the same as long as that scale stays in its octave.
    std::optional<RigidPlacement> of(const Affine& map) const;

private:
    static constexpr int max_scale_bits = 4; ///< up or down

    /// The factor that replaces one of the map, Q14, and for the scale of the canvas.
    std::int32_t factor(std::int32_t q16) const;

    std::int32_t base_;    ///< the scale of the canvas, so that 2^-max_scale_bits of it is whole
    std::int64_t inverse_; ///< 1 / base_, in 2^-(16 + inverse_bits)
};

/// The values of the tracks of an item at the time of a prepared scene.
class ItemState {
public:
    /// The arguments must outlive it.
    ItemState(const SceneView& scene, const PreparedScene& prepared, const Node& item)
        : scene_{scene}, prepared_{prepared}, item_{item}
    {
    }

    /// 0 … 255; 0 if the item is not visible at all.
    std::uint32_t opacity() const;
    /// Maps the item's own space to that of what it is in.
    Space placement() const;
    Point pivot() const;
    /// The colour of the fill; only of what is filled.
    Colour fill() const { return colour(Property::fill, item_.style.fill); }
    /// The colour of the stroke; only of what is stroked.
    Colour stroke() const { return colour(Property::stroke, item_.style.stroke); }
    /// The width of the stroke; only of what is stroked.
    Fixed width() const;
    /// Which part of its strokes is drawn, and how they are dashed.
    [[gnu::cold]] Trim trim() const;

private:
    const TrackState* track(Property property) const;
    std::int32_t fine(Property property) const;
    [[gnu::cold]] Dashes dashes() const;
    Colour colour(Property property, std::uint8_t without_track) const;

    const SceneView& scene_;
    const PreparedScene& prepared_;
    const Node& item_;
};

}
