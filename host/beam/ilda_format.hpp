#pragma once

#include "core/beam/beam_profile.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

// The ILDA Image Data Transfer Format: sections, each a header of 32 bytes and its records. All numbers are
// big-endian. The layout is described where it is written: ilda_writer.cpp.

/// What the records of a section are. There is no 3: it was dropped.
enum class IldaFormat : std::uint8_t {
    indexed_3d = 0,
    indexed_2d = 1,
    palette = 2,
    true_colour_3d = 4,
    true_colour_2d = 5,
};

inline constexpr std::array<char, 4> ilda_magic{'I', 'L', 'D', 'A'};
inline constexpr std::size_t ilda_header_bytes = 32;
inline constexpr std::size_t ilda_name_bytes = 8;
inline constexpr std::size_t max_ilda_records = 0xFFFF; ///< in a section; also the maximum of frames
inline constexpr std::size_t max_ilda_colours = 256;    ///< in a palette

/// Bits of the status of a point.
inline constexpr std::uint8_t ilda_last_point = 0x80;
inline constexpr std::uint8_t ilda_blanked = 0x40;

constexpr bool has_depth(IldaFormat format)
{
    return format == IldaFormat::indexed_3d || format == IldaFormat::true_colour_3d;
}

constexpr bool is_indexed(IldaFormat format)
{
    return format == IldaFormat::indexed_3d || format == IldaFormat::indexed_2d;
}

/// Coordinates of two bytes each, the status, and an index or three bytes of colour; for a palette only the
/// latter.
constexpr std::size_t ilda_record_bytes(IldaFormat format)
{
    if (format == IldaFormat::palette)
        return 3;
    return (has_depth(format) ? 6 : 4) + 1 + (is_indexed(format) ? 1 : 3);
}

/// The 64 colours that are valid in an ILDA file until it has a palette: red 0, yellow 16, green 24, cyan 31,
/// blue 40, magenta 48, white 56. The specification suggests them; several programs agree on each.
std::span<const Colour> default_ilda_palette();

/// The colours of points by numbers. It begins with the default ones, in their places, so that these are
/// correct for readers that skip palettes as well.
class IldaPalette {
public:
    IldaPalette();
    /// With the lit colours of all these pictures.
    explicit IldaPalette(std::span<const std::vector<BeamPoint>> frames);

    /// Adds the lit colours among them, as far as there is room.
    void add(std::span<const BeamPoint> points);
    /// The number of the colour, or of the nearest one.
    std::uint8_t index(Colour colour) const;

    std::span<const Colour> colours() const { return colours_; }
    /// Whether it differs from the default one.
    bool is_needed() const { return colours_.size() > default_ilda_palette().size(); }
    /// Whether not all colours have found room.
    bool is_too_small() const { return is_too_small_; }

private:
    std::vector<Colour> colours_;
    bool is_too_small_ = false;
};

}
