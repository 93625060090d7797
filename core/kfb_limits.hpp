#pragma once

#include <cstddef>
#include <cstdint>

/// What the scene format limits. The compiler refuses what exceeds it, so does SceneView::parse.
namespace kfast::kfb {

inline constexpr std::uint8_t version = 1;
inline constexpr std::size_t header_bytes = 32;
inline constexpr int max_canvas = 2047;                    ///< pixels in each direction
inline constexpr std::uint32_t max_frame_rate = 1'000'000; ///< in 1/1000 fps
inline constexpr std::int32_t max_time = 1'000'000 * 1024; ///< ticks
inline constexpr std::uint32_t max_drawing_points = 65535;
inline constexpr std::uint32_t max_edges = 65534;
/// Enough for the most curved cubic that 16-bit coordinates can describe, within 1/32 px.
inline constexpr std::uint32_t max_curve_pieces = 1024;
inline constexpr int max_width = 65535; ///< of a stroke, in 1/16 px
/// Points of the drawings of all keys together: what parse() has to walk through at the start.
inline constexpr std::uint32_t max_key_points = 1U << 22;

}
