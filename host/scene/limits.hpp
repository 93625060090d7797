#pragma once

#include "core/kfb_limits.hpp"
#include "core/time.hpp"

#include <cstddef>
#include <string>

namespace kfast::scene {

/// In a drawing: one where a stroke begins and one for each of its segments.
inline constexpr std::size_t most_points = kfb::max_drawing_points;
/// In all drawings, keys counted as well.
inline constexpr std::size_t most_points_of_scene = kfb::max_key_points;
inline constexpr std::size_t most_keys = 65'535;                          ///< of an item
inline constexpr std::size_t most_ordered_items = kfb::max_ordered_items; ///< beside each other
inline constexpr std::size_t most_symbols = kfb::max_symbols;             ///< of items, in use
inline constexpr std::size_t most_clips = kfb::max_clips;
inline constexpr std::size_t longest_name = kfb::max_name_bytes;
inline constexpr int deepest_item = kfb::max_depth; ///< groups and uses around it
inline constexpr std::size_t most_colours = 255;    ///< in use, and names in the palette
inline constexpr int most_frames = kfb::max_time / Time::ticks_per_frame;

inline constexpr int widest_canvas = kfb::max_canvas;      ///< pixels, in each direction
inline constexpr int fastest = kfb::max_frame_rate / 1000; ///< frames per second
inline constexpr int widest_stroke = kfb::max_width / 16;  ///< pixels

inline std::string too_many_points()
{
    return "a drawing holds at most " + std::to_string(most_points) + " points";
}

inline std::string too_deep()
{
    return "groups and uses lie at most " + std::to_string(deepest_item) + " deep in each other";
}

}
