#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/ilda_format.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A point of an ILDA file, with the colour that its index represents.
struct IldaPoint {
    BeamPoint point; ///< blanked ones have no colour
    std::int16_t z = 0;
};

struct IldaFrame {
    IldaFormat format = IldaFormat::indexed_3d;
    std::string name;    ///< up to eight bytes, of any kind
    std::string company; ///< up to eight bytes, of any kind
    std::uint16_t number = 0;
    std::uint16_t frames = 0; ///< how many there are, as given in the frame; 0 if it is not
    std::uint8_t projector = 0;
    std::vector<IldaPoint> points; ///< at least one
};

struct IldaContents {
    std::vector<IldaFrame> frames;
    std::size_t palettes = 0;
};

/// Reads any bytes. Throws std::invalid_argument where a section is none, breaks off or has an unknown
/// format, where the last point of a frame is not marked or another one is marked as it, where a colour is in
/// no palette, where the closing section is missing or something follows it, and for a file without frames.
/// The text begins with the position: "at byte 1234: …".
IldaContents read_ilda(std::span<const std::byte> file);

/// The facts of an ILDA file. Lengths are in units of the field.
struct IldaFacts {
    std::set<IldaFormat> formats; ///< of frames
    std::size_t points = 0;
    std::size_t lit_points = 0;
    std::size_t max_points = 0;  ///< in a frame
    FieldPoint min;              ///< of all points: left and bottom,
    FieldPoint max;              ///< right and top
    double longest_lit_step = 0; ///< to a lit point, from the one before it in the frame
    double longest_blanked_step = 0;
};

/// `contents` has at least one frame.
IldaFacts ilda_facts(const IldaContents& contents);

}
