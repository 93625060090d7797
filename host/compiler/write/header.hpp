#pragma once

#include "core/scene/format.hpp"
#include "core/time/time.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// A time of at least 0 as the format has it: twice the frames, or twice the ticks and one.
constexpr std::uint32_t time_code(Time time)
{
    const auto ticks = static_cast<std::uint32_t>(time.ticks);
    const bool is_whole = ticks % Time::ticks_per_frame == 0;
    return kfb::time_code::in_ticks.put(!is_whole) |
           kfb::time_code::number.put(is_whole ? ticks / Time::ticks_per_frame : ticks);
}

/// The sections that a scene may lack.
struct Sections {
    bool inputs = false;
    bool marks = false;
    bool bones = false;
    bool symbols = false;
};

/// What the outlines of a picture need at most, on a panel as large as the canvas.
struct OutlineNeeds {
    std::uint32_t bytes = 0;       ///< a multiple of 4
    std::uint32_t borders = 0;     ///< in bands of four rows, all bands together
    std::uint32_t cache_bytes = 0; ///< for what is kept from picture to picture; a multiple of 4
};

/// Appends the header of `scene` from what outlines need on, which is nothing, and its palette
/// (docs/format.md).
void write_header(const scene::Scene& scene, const Sections& sections, ByteWriter& bytes);

/// Puts magic, version, checksum and size before everything else.
std::vector<std::byte> sealed(const ByteWriter& body);

/// Writes what outlines need into a file that is sealed, and seals it again.
void set_outline_needs(std::vector<std::byte>& file, const OutlineNeeds& needs);

}
