#pragma once

#include "host/compiler/pack/byte_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Appends at least one value, no two of them 2^31 or more apart, as the core's PackedValues reads them
/// (docs/format.md, "Values"), in as few bytes as it takes.
void write_values(std::span<const std::int32_t> values, ByteWriter& bytes);

}
