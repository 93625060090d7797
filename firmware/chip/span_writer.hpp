#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Writes little-endian numbers from front to back into memory that has room for them.
class SpanWriter {
public:
    constexpr explicit SpanWriter(std::span<std::byte> bytes) : at_{bytes.data()} {}

    constexpr void u8(std::uint32_t value) { *at_++ = static_cast<std::byte>(value); }
    constexpr void u16(std::uint32_t value)
    {
        u8(value);
        u8(value >> 8);
    }
    constexpr void u32(std::uint32_t value)
    {
        u16(value);
        u16(value >> 16);
    }
    constexpr void bytes(std::span<const std::byte> bytes)
    {
        for (const std::byte byte : bytes)
            *at_++ = byte;
    }

private:
    std::byte* at_;
};

}
