#pragma once

#include "host/compiler/byte_writer.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// Which of the sections that a scene may lack there are.
struct Sections {
    bool inputs = false;
    bool marks = false;
    bool bones = false;
    bool symbols = false;
};

/// Appends the header of `scene` from the bytes for outlines on, which are 0, and its palette
/// (docs/format.md).
void write_header(const scene::Scene& scene, const Sections& sections, ByteWriter& bytes);

/// Puts magic, version, checksum and size before everything else.
std::vector<std::byte> sealed(const ByteWriter& body);

/// Writes the bytes for outlines into a file that is sealed, and seals it again.
void set_outline_bytes(std::vector<std::byte>& file, std::uint32_t outline_bytes);

}
