#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// Appends little-endian numbers; the counterpart of the core's ByteReader.
class ByteWriter {
public:
    void u8(std::uint32_t value) { bytes_.push_back(static_cast<std::byte>(value & 0xFF)); }

    void u16(std::uint32_t value)
    {
        u8(value);
        u8(value >> 8);
    }

    void u32(std::uint32_t value)
    {
        u16(value);
        u16(value >> 16);
    }

    void varint(std::uint32_t value)
    {
        for (; value >= 0x80; value >>= 7)
            u8(value | 0x80);
        u8(value);
    }

    /// 2 v for v >= 0, -2 v - 1 below. `value` is within ±2^30.
    void signed_varint(std::int32_t value)
    {
        const std::uint32_t twice = static_cast<std::uint32_t>(value) * 2;
        varint(value < 0 ? ~twice : twice);
    }

    /// A varint, the number of `bytes`, and these.
    void block(std::span<const std::byte> bytes)
    {
        varint(static_cast<std::uint32_t>(bytes.size()));
        append(bytes);
    }

    void append(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

    std::size_t size() const { return bytes_.size(); }
    const std::vector<std::byte>& bytes() const { return bytes_; }

private:
    std::vector<std::byte> bytes_;
};

}
