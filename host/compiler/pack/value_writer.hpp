#pragma once

#include "host/compiler/pack/byte_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Appends numbers of any width to a ByteWriter, the highest bit first; the counterpart of the core's
/// BitReader. Its destructor completes the last byte.
class BitWriter {
public:
    explicit BitWriter(ByteWriter& bytes) : bytes_{bytes} {}
    BitWriter(const BitWriter&) = delete;
    BitWriter& operator=(const BitWriter&) = delete;

    ~BitWriter()
    {
        if (pending_count_ != 0)
            bytes_.u8(pending_ << (8 - pending_count_));
    }

    /// Appends the lowest `count` bits of `value`, at most 24.
    void put(std::int32_t value, std::uint32_t count)
    {
        pending_ = pending_ << count | (static_cast<std::uint32_t>(value) & ((1U << count) - 1));
        for (pending_count_ += count; pending_count_ >= 8;) {
            pending_count_ -= 8;
            bytes_.u8(pending_ >> pending_count_);
        }
    }

    /// Appends the lowest `count` bits of `value`, at most 32.
    void number(std::uint32_t value, std::uint32_t count)
    {
        if (count > 16)
            put(static_cast<std::int32_t>(value >> 16), count - 16);
        put(static_cast<std::int32_t>(value), std::min(count, 16U));
    }

private:
    ByteWriter& bytes_;
    std::uint32_t pending_ = 0;
    std::uint32_t pending_count_ = 0;
};

/// Appends at least one value, no two of them 2^31 or more apart, as the core's PackedValues reads them
/// (docs/format.md, "Values"), in as few bytes as it takes.
void write_values(std::span<const std::int32_t> values, ByteWriter& bytes);

}
