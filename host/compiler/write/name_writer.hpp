#pragma once

#include "host/compiler/pack/byte_writer.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// Appends a name of at most 255 bytes as the core's read_name() reads it.
inline void write_name(std::string_view name, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(name.size()));
    bytes.append(std::as_bytes(std::span{name}));
}

}
