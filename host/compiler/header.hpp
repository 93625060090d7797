#pragma once

#include "host/compiler/byte_writer.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// Appends the header of `scene` from the number of edges on, and its palette (docs/format.md).
void write_header(const scene::Scene& scene, std::uint32_t edges, std::size_t law_pairs, ByteWriter& bytes);

/// Puts magic, version, checksum and size before everything else.
std::vector<std::byte> sealed(const ByteWriter& body);

}
