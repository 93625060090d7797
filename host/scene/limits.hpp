#pragma once

#include <cstddef>
#include <string>

namespace kfast::scene {

/// In a drawing: one where a stroke begins and one for each of its segments.
inline constexpr std::size_t most_points = 65'535;
inline constexpr std::size_t most_keys = 65'535; ///< of an object
inline constexpr std::size_t most_objects = 65'535;
inline constexpr std::size_t most_colours = 255; ///< in use, and names in the palette
inline constexpr int most_frames = 1'000'000;

inline constexpr int widest_canvas = 2047;    ///< pixels, in each direction
inline constexpr int fastest = 1000;          ///< frames per second
inline constexpr double widest_stroke = 4095; ///< pixels

inline std::string too_many_points()
{
    return "a drawing holds at most " + std::to_string(most_points) + " points";
}

}
