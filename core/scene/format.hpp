#pragma once

#include "core/bytes/bit_field.hpp"
#include "core/time/velocity_law.hpp"

#include <cstddef>
#include <cstdint>

/// Where the bits of a compiled scene are and what its special numbers mean, for code that reads, writes and
/// checks it. Each namespace is a record of docs/format.md; the comment before it names the section, and
/// tests/docs/format_test.py compares the two. Fields of several bits hold numbers, or enumerations whose
/// values are those of the format: Loop, InputType, Align, BoneQuantity, ItemKind, InputLeaf, Cap, Join,
/// Property, BeamParts, SegmentMix, StrokeEnd. What the numbers may be is in core/scene/kfb_limits.hpp.
namespace kfast::kfb {

/// "Numbers": a time code.
namespace time_code {
inline constexpr BitFlag<0> in_ticks; ///< else in frames
inline constexpr BitField<1, 31> number;
}

/// "Header": the first four bytes as one little-endian number.
namespace tag {
inline constexpr BitField<0, 24> magic;
inline constexpr BitField<24, 8> version;
inline constexpr std::uint32_t magic_value = 'K' | 'F' << 8 | 'B' << 16; ///< of `magic`
}

/// "Header"
namespace header {
inline constexpr std::size_t checksum_end = 8; ///< the checksum covers everything after itself
/// The unit in which bytes of outlines and of the cache are stored.
inline constexpr std::uint32_t memory_unit = 4;

inline constexpr BitField<0, 2> loop;
inline constexpr BitFlag<2> has_camera;
inline constexpr BitFlag<3> has_opacity;
inline constexpr BitFlag<4> has_marks;
inline constexpr BitFlag<5> has_bones;
inline constexpr BitFlag<6> has_symbols;
inline constexpr BitFlag<7> has_inputs;
}

/// "Header": the rate.
namespace rate {
inline constexpr BitFlag<0> in_1000_seconds; ///< else the frames of one second
inline constexpr BitField<1, 31> number;
}

/// "Laws": the byte of a pair.
namespace law_pair {
inline constexpr BitField<0, 4> x;
inline constexpr BitField<4, 4, 8> y;
inline constexpr std::uint32_t as_for_x = 15; ///< in the place of the law for y

/// The parameters of a law, 16 bits each: calls `use` for each of the members that holds one, in the order in
/// which they are stored. `Law` is VelocityLaw, which may be const.
template <class Law, class Use>
constexpr void each_parameter(Law& law, Use use)
{
    if (law.kind == VelocityLaw::Kind::steps || is_spring(law))
        use(law.count);
    if (law.kind == VelocityLaw::Kind::bezier || law.kind == VelocityLaw::Kind::spring)
        for (const auto number : {&VelocityLaw::x1, &VelocityLaw::y1, &VelocityLaw::x2, &VelocityLaw::y2})
            use(law.*number);
}
}

/// "Clocks": the byte of what happens at the end.
namespace clock {
inline constexpr BitField<0, 2> loop;
}

/// "Texts": characters that follow each other, 4 bytes.
namespace glyph_range {
inline constexpr std::size_t bytes = 4;
inline constexpr BitField<0, 8> glyph;
inline constexpr BitField<8, 24> character;
}

/// "Key times": the two bytes of the form.
namespace key_times {
inline constexpr std::uint32_t use_default = 0; ///< in the place of their number, and nothing follows
inline constexpr BitField<0, 5> time_width;
inline constexpr BitField<5, 4> time_shift;
inline constexpr BitField<9, 6> law_width;
inline constexpr BitFlag<15> has_driver; ///< else they go by the time of the scene
inline constexpr std::uint32_t max_law_width = 8;
/// The maximum of width + shift: a time stays within 32 bits until it is refused.
inline constexpr std::uint32_t max_time_bits = 30;
}

/// "Values": the byte of the form.
namespace values {
inline constexpr BitField<0, 5> width;
inline constexpr BitField<5, 3, 8> unit;
inline constexpr std::uint32_t degree_unit = 7; ///< whole degrees; other units are powers of two
}

/// "Bones": the byte of flags. That of a quantity that has keys is its BoneQuantity.
namespace bone {
inline constexpr BitField<0, 4> moved;
inline constexpr BitFlag<4> is_at_tip;
inline constexpr BitFlag<5> turns_as_written;
inline constexpr BitFlag<6> is_straight;
inline constexpr BitFlag<7> in_pixels;
}

/// "Items": the first byte.
namespace item {
inline constexpr BitField<0, 2> kind;
inline constexpr BitFlag<2> has_tracks;
inline constexpr BitFlag<3> is_filled;
inline constexpr BitFlag<4> is_stroked;
inline constexpr BitFlag<5> is_even_odd;
inline constexpr BitFlag<6> has_arrivals;
inline constexpr BitFlag<7> is_carried;
inline constexpr std::uint32_t wire_frame = 2; ///< in the place of an InputLeaf: an object with depths
/// In the place of the number of a skeleton, which is counted from 1.
inline constexpr std::uint32_t by_backbones = 0;
}

/// "Items": cap and join of a stroke.
namespace stroke {
inline constexpr BitField<0, 2> cap;
inline constexpr BitField<2, 2> join;
}

/// "Live items": the first byte of a label.
namespace label {
inline constexpr BitField<0, 2> align;
inline constexpr BitFlag<2> shows_number;
inline constexpr BitField<3, 5, 8> unused; ///< 0
}

/// "Live items": how many digits a number has before the point.
namespace number_format {
inline constexpr BitField<0, 4> digits;
inline constexpr BitField<4, 4, 8> places;
}

/// "Live items": the glyphs of a label that shows a number; 0 to 9 are digits, and those from `first_other`
/// on what stands around it.
namespace number_glyph {
inline constexpr std::uint32_t minus = 10;
inline constexpr std::uint32_t point = 11;
inline constexpr std::uint32_t gap = 12; ///< in the place of a digit
inline constexpr std::uint32_t first_other = 13;
}

/// "Live items": two glyphs that are kerned.
namespace kerning {
inline constexpr std::size_t bytes = 2;
inline constexpr BitField<0, 8> right;
inline constexpr BitField<8, 8, 16> left;
}

/// "Skins"
namespace skin {
inline constexpr std::int32_t whole_weight = 65'536; ///< all weights of a point
inline constexpr std::int32_t coarse_weight = 256;   ///< the unit of weights in one byte
inline constexpr BitField<0, 2> bones;               ///< of a run, less 1
inline constexpr BitFlag<2> has_fine_weights;        ///< in two bytes, else in one
inline constexpr BitField<3, 29> points;             ///< of a run, less 1

/// What an object has in place of the offset of a skin when the bone moves all points. Its own inverse.
constexpr std::int32_t of_bone(std::int32_t bone) { return -1 - bone; }
}

/// "Tracks": the byte before them.
namespace tracks {
inline constexpr BitField<0, 7> count;
inline constexpr BitFlag<7> has_beam_style;
}

/// "Tracks": the first byte of each.
namespace track {
inline constexpr BitField<0, 6> property;
inline constexpr BitFlag<6> is_smooth;
inline constexpr BitFlag<7> is_fixed;
}

/// "Drawings": in place of the first byte of a form, where the form is.
namespace repeated_form {
inline constexpr BitField<0, 2> mix; ///< SegmentMix::repeat
inline constexpr BitFlag<2> mirrors_x;
inline constexpr BitFlag<3> mirrors_y;
inline constexpr BitField<4, 4, 8> unused; ///< 0
}

/// "Forms": the first two bytes as one little-endian number.
namespace form {
inline constexpr BitField<0, 2> mix;
inline constexpr BitField<2, 2> end;
inline constexpr BitFlag<4> has_sparse_ends;
inline constexpr BitFlag<5> has_sparse_controls;
inline constexpr BitField<6, 2> smoothness;
inline constexpr BitField<8, 5> end_width;
inline constexpr BitField<13, 3, 16> less_control_width; ///< how much less than `end_width`
}

/// "Forms": the number of segments.
namespace segments {
inline constexpr BitFlag<0> are_predicted;
inline constexpr BitField<1, 31> count;
}

/// "Forms": the byte of predicted cubics.
namespace predicted_cubics {
inline constexpr BitField<0, 5> first_control_width;
inline constexpr BitField<5, 3, 8> more_control_width; ///< how much more than `end_width`
}

/// "Forms": the two bits before a vector whose kind is sparse.
namespace sparse_vector {
inline constexpr std::uint32_t bits = 2;
inline constexpr BitFlag<0> has_y;
inline constexpr BitFlag<1> has_x;
}

}
