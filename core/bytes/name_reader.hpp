#pragma once

#include "core/bytes/byte_reader.hpp"

#include <algorithm>
#include <string_view>

namespace kfast {

/// A name as the format stores it: a byte, how long it is, and its letters. Borrows the bytes.
inline std::string_view read_name(ByteReader& bytes)
{
    const std::size_t length = bytes.u8();
    const auto* letters = reinterpret_cast<const char*>(bytes.rest().data());
    const std::string_view name{letters, std::min(length, bytes.left())};
    bytes.skip(length);
    return name;
}

}
