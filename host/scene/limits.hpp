#pragma once

#include "core/kfb_limits.hpp"
#include "core/time.hpp"

#include <cstddef>
#include <string>

namespace kfast::scene {

/// In a drawing: one where a stroke begins and one for each of its segments.
inline constexpr std::size_t most_points = kfb::max_drawing_points;
inline constexpr std::size_t most_keys = 65'535; ///< of an object
inline constexpr std::size_t most_objects = 65'535;
inline constexpr std::size_t most_colours = 255; ///< in use, and names in the palette
inline constexpr int most_frames = kfb::max_time / Time::ticks_per_frame;

inline constexpr int widest_canvas = kfb::max_canvas;      ///< pixels, in each direction
inline constexpr int fastest = kfb::max_frame_rate / 1000; ///< frames per second
inline constexpr int widest_stroke = kfb::max_width / 16;  ///< pixels

inline std::string too_many_points()
{
    return "a drawing holds at most " + std::to_string(most_points) + " points";
}

}
