#pragma once

#include <cstddef>
#include <cstdint>

/// The limits of the scene format. The compiler and SceneView::parse refuse what exceeds them.
namespace kfast::kfb {

inline constexpr std::uint8_t version = 3;
inline constexpr int max_canvas = 2047;                    ///< pixels in each direction
inline constexpr std::uint32_t max_frame_rate = 1'000'000; ///< in 1/1000 fps
inline constexpr std::int32_t max_time = 1'000'000 * 1024; ///< ticks
inline constexpr std::int32_t min_coordinate = -32768;     ///< in 1/16 px, and of an order
inline constexpr std::int32_t max_coordinate = 32767;
inline constexpr std::uint32_t max_drawing_points = 65535;
inline constexpr std::uint32_t max_outline_bytes = 1U << 22; ///< of one picture
inline constexpr std::uint32_t max_borders = 1U << 20;       ///< of one picture, in bands of four rows
inline constexpr std::uint32_t max_cache_bytes = 1U << 22;   ///< for what is kept from picture to picture
inline constexpr int max_width = 65535;                      ///< of a stroke, in 1/16 px
inline constexpr std::uint32_t min_miter_limit = 8;          ///< in 1/8 widths
inline constexpr int min_hatch_spacing = 8;                  ///< in 1/16 px
inline constexpr std::size_t max_law_pairs = 255;            ///< besides that of constant laws
inline constexpr std::size_t max_symbols = 255;
inline constexpr std::size_t max_clips = 255;
inline constexpr std::size_t max_clocks = 223; ///< their numbers as drivers of keys are 33 … 255
inline constexpr std::uint32_t max_inputs = 32;
inline constexpr std::int32_t max_input_value = 1'000'000'000; ///< in 1/1000, in each direction
inline constexpr std::uint32_t max_decimals = 3;
inline constexpr std::uint32_t max_digits = 10;   ///< before the point, that a format asks for
inline constexpr std::uint32_t max_around = 45;   ///< glyphs around a number
inline constexpr std::uint32_t max_text = 60;     ///< characters of a text: what a report of the link carries
inline constexpr std::uint32_t max_glyphs = 255;  ///< of a text
inline constexpr std::int32_t advance_one = 4096; ///< a pixel, in the unit of the widths of a label's letters
inline constexpr std::int32_t max_text_width = 4095 * advance_one;
/// Points of a drawing from outside, all strokes together.
inline constexpr std::uint32_t max_live_points = 4096;
inline constexpr std::size_t max_name_bytes = 255;
/// Nested groups and uses.
inline constexpr std::uint32_t max_depth = 8;
/// Items of the whole scene, those of a symbol counted wherever it is used.
inline constexpr std::uint32_t max_items = 65535;
/// Items as they are stored, and symbols: a player has a record of each. One less than its numbers of 16 bits
/// can identify.
inline constexpr std::uint32_t max_nodes = 65535;
/// Tracks of items as they are stored, of bones, and those of the keys of objects: numbers of 16 bits, too.
inline constexpr std::uint32_t max_tracks = 65535;
/// Fills and strokes of the whole scene, and two for each item that may be blended as a whole; those of a
/// symbol counted wherever it is used. Steps have numbers of 16 bits.
inline constexpr std::uint32_t max_paint_steps = 0xFFFF;
/// Items of a list in which one has an order: the player searches all of them for each.
inline constexpr std::uint32_t max_ordered_items = 256;
inline constexpr std::int32_t max_scale = 64 * 4096; ///< in 1/4096, in each direction
inline constexpr std::int32_t max_turn = 16 * 65536; ///< of a rotation, in 1/65536 turn, in each direction
inline constexpr std::int32_t min_camera = 16;       ///< pixels
inline constexpr std::int32_t max_camera = 32767;
inline constexpr std::uint32_t max_path = 8'388'607; ///< length in 1/16 px
inline constexpr std::uint32_t max_bones = 255;      ///< of one skeleton, and skeletons
inline constexpr std::uint32_t max_bones_together = 1024;
inline constexpr std::int32_t max_bone_turn =
    16 * 65536;                                        ///< of angles that tween as written, in 1/65536 turn
inline constexpr std::int32_t max_bone_length = 65535; ///< in 1/16 px
inline constexpr std::uint32_t max_bones_at_point = 4;
/// Backbones: 2^n sixteenths of a pixel represent a segment and a width.
inline constexpr std::uint32_t min_unit_bits = 4;
inline constexpr std::uint32_t max_unit_bits = 15;
inline constexpr std::uint32_t max_backbones = 32;          ///< of one object
inline constexpr std::uint32_t max_backbone_segments = 255; ///< of one object

}
