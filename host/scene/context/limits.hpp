#pragma once

#include "core/scene/kfb_limits.hpp"
#include "core/time/time.hpp"
#include "host/geometry/drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace kfast::scene {

/// In all drawings, keys counted as well.
inline constexpr std::size_t max_points_of_scene = std::size_t{1} << 22;
inline constexpr std::size_t max_keys = 65'535;                          ///< of an item
inline constexpr std::size_t max_ordered_items = kfb::max_ordered_items; ///< in one list
inline constexpr std::size_t max_symbols = kfb::max_symbols;             ///< of items, in use
inline constexpr std::size_t max_clips = kfb::max_clips;
inline constexpr std::size_t max_clocks = kfb::max_clocks; ///< times of their own
inline constexpr std::size_t max_inputs = kfb::max_inputs;
inline constexpr int max_live_points = kfb::max_live_points; ///< of a drawing from outside
inline constexpr std::size_t max_backbones = kfb::max_backbones;
inline constexpr std::size_t max_backbone_segments = kfb::max_backbone_segments; ///< of a skeleton
inline constexpr std::size_t max_skeletons = kfb::max_bones;
inline constexpr std::size_t max_bones = kfb::max_bones;                   ///< of a skeleton
inline constexpr std::size_t max_bones_together = kfb::max_bones_together; ///< of all skeletons
/// For all poses of a scene together, a pose counted wherever its name is used: copies would soon be more
/// than any memory holds.
inline constexpr std::size_t max_posed_bones = std::size_t{1} << 19;
inline constexpr std::size_t max_bones_at_point = kfb::max_bones_at_point;
inline constexpr int deepest_item = kfb::max_depth; ///< groups and uses around it
inline constexpr std::size_t max_variables = 1000;
inline constexpr std::size_t max_variable_name = 40; ///< letters
inline constexpr std::size_t max_colours = 255;      ///< in use, and names in the palette
inline constexpr int max_frames = kfb::max_time / Time::ticks_per_frame;

inline constexpr int widest_canvas = kfb::max_canvas;      ///< pixels, in each direction
inline constexpr int fastest = kfb::max_frame_rate / 1000; ///< frames per second
inline constexpr int widest_stroke = kfb::max_width / 16;  ///< pixels

inline constexpr std::int32_t longest_bone = kfb::max_bone_length; ///< 1/16 px

/// Whether the format can store it, in 1/16 px.
constexpr bool is_bone_origin(std::int32_t coordinate)
{
    return coordinate >= kfb::min_coordinate && coordinate <= kfb::max_coordinate;
}

inline std::string too_far_from_parent()
{
    return "this bone begins more than 2047 px from its parent's origin";
}

inline std::string too_deep()
{
    return "groups and uses lie at most " + std::to_string(deepest_item) + " deep in each other";
}

}
