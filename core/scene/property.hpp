#pragma once

#include "core/scene/kfb_limits.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast {

/// What a track of an item changes; the values are those of the scene format.
///
/// An item is scaled and rotated about its pivot, then moved: p' = position + pivot + Rx (Ry (Rz (scale (p -
/// pivot)))). z points at the viewer. Rz turns x towards y, Rx turns y towards z, Ry turns z towards x (as in
/// CSS): a rotation about x takes the upper edge away from the viewer, one about y the right edge.
enum class Property : std::uint8_t {
    x,          ///< of the position, in 1/16 px
    y,          ///< of the position, in 1/16 px
    z,          ///< of the position, in 1/16 px
    rotation_x, ///< in 1/65536 turn; may be several turns
    rotation_y, ///< in 1/65536 turn; may be several turns
    rotation,   ///< about z, clockwise, in 1/65536 turn; may be several turns
    scale_x,    ///< in 1/4096; negative mirrors
    scale_y,    ///< in 1/4096; negative mirrors
    pivot_x,    ///< in 1/16 px
    pivot_y,    ///< in 1/16 px
    along,      ///< how far the pivot is along the item's path, in 1/65536 of it; only of items with a path
    opacity,    ///< 0 … 255
    order,      ///< among the items beside it, -32768 … 32767; the lowest is painted first. Does not tween
    visible,    ///< 0 or 1; does not tween
    fill,       ///< index of the palette; only of filled objects. Not in smooth tracks, as the two before
    stroke,     ///< index of the palette; only of stroked objects. Not in smooth tracks
    width,      ///< of the stroke, in 1/16 px; only of stroked objects
    // Which part of the strokes of an object is drawn, in 1/65536 of their length: from one share to the
    // other, both moved by an offset. Only of objects and live items that are no wire frames.
    trim_from,
    trim_to,
    trim_offset,
    trim_mode, ///< a TrimMode; does not tween
    // How the strokes of an object are dashed, in 1/64 px. Only of objects and live items that are stroked
    // and no wire frames. The pattern has the lengths up to the last one that has a track.
    dash_offset, ///< where in the pattern strokes begin
    dash_1,
    gap_1,
    dash_2,
    gap_2,
    dash_3,
    gap_3,
    max_dashes, ///< beyond them strokes are drawn whole; does not tween
};

inline constexpr std::size_t property_count = 29;

/// Whether it places an item, as the first of them do.
constexpr bool places_item(Property property) { return property <= Property::along; }

/// Whether it says which part of strokes is drawn.
constexpr bool is_of_trim(Property property)
{
    return property >= Property::trim_from && property <= Property::trim_mode;
}

/// Whether it says which part of strokes is drawn, or how they are dashed.
constexpr bool cuts_strokes(Property property) { return property >= Property::trim_from; }

/// Whether it says how strokes are dashed.
constexpr bool is_of_dashes(Property property) { return property >= Property::dash_offset; }

/// Whether it is the length of a dash or a gap.
constexpr bool is_dash_length(Property property)
{
    return property >= Property::dash_1 && property <= Property::gap_3;
}

/// Whether it moves, bends, widens or cuts something, so that its outlines change.
constexpr bool shapes_item(Property property)
{
    return places_item(property) || property == Property::width || cuts_strokes(property);
}

inline constexpr std::int32_t scale_one = 4096;   ///< a scale that changes nothing
inline constexpr std::int32_t path_whole = 65536; ///< the end of a path, or of the strokes that are trimmed
inline constexpr std::int32_t max_trim_offset = 16 * path_whole;
inline constexpr std::int32_t max_trim_mode = 2;
inline constexpr std::int32_t dash_pixel = 64; ///< of dash lengths and offsets
inline constexpr std::int32_t max_dash_pixels = 16384;
inline constexpr std::int32_t max_dash_length = max_dash_pixels * dash_pixel;
inline constexpr std::int32_t max_dash_count = 1024;
inline constexpr std::int32_t default_max_dashes = 64;

/// Whether a track of it may be smooth: its values are amounts.
constexpr bool may_be_smooth(Property property)
{
    return property != Property::order && property != Property::visible && property != Property::fill &&
           property != Property::stroke && property != Property::trim_mode &&
           property != Property::max_dashes;
}

/// Whether it tweens by the law for y; all others by that for x.
constexpr bool goes_by_y(Property property)
{
    return property == Property::y || property == Property::scale_y;
}

/// The value without a track. For fill, stroke and width it is the object's own, and 0 here.
constexpr std::int32_t value_without_track(Property property)
{
    switch (property) {
    case Property::scale_x:
    case Property::scale_y:
        return scale_one;
    case Property::opacity:
        return 255;
    case Property::visible:
        return 1;
    case Property::trim_to:
        return path_whole;
    case Property::max_dashes:
        return default_max_dashes;
    default:
        return 0;
    }
}

struct ValueRange {
    std::int32_t min;
    std::int32_t max;
};

/// The values that keys of a track may have; between them, bezier laws may overshoot.
constexpr ValueRange value_range(Property property)
{
    switch (property) {
    case Property::x:
    case Property::y:
    case Property::z:
    case Property::pivot_x:
    case Property::pivot_y:
    case Property::order:
        return {kfb::min_coordinate, kfb::max_coordinate};
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
        return {-kfb::max_turn, kfb::max_turn};
    case Property::scale_x:
    case Property::scale_y:
        return {-kfb::max_scale, kfb::max_scale};
    case Property::along:
    case Property::trim_from:
    case Property::trim_to:
        return {0, path_whole};
    case Property::trim_offset:
        return {-max_trim_offset, max_trim_offset};
    case Property::trim_mode:
        return {0, max_trim_mode};
    case Property::opacity:
    case Property::fill:
    case Property::stroke:
        return {0, 255};
    case Property::visible:
        return {0, 1};
    case Property::width:
        return {0, kfb::max_width};
    case Property::dash_offset:
        return {-max_dash_length, max_dash_length};
    case Property::dash_1:
    case Property::gap_1:
    case Property::dash_2:
    case Property::gap_2:
    case Property::dash_3:
    case Property::gap_3:
        return {0, max_dash_length};
    case Property::max_dashes:
        return {1, max_dash_count};
    }
    return {0, 0};
}

}
