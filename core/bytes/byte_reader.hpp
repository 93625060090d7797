#pragma once

#include "core/bytes/expects.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// Reads little-endian numbers from front to back. Past the end it reads zeros and remembers that it did.
class ByteReader {
public:
    ByteReader() = default;
    explicit ByteReader(std::span<const std::byte> bytes)
        : at_{bytes.data()}, end_{bytes.data() + bytes.size()}
    {
    }

    std::uint32_t u8()
    {
        if (at_ == end_) {
            overrun_ = true;
            return 0;
        }
        return std::to_integer<std::uint32_t>(*at_++);
    }

    std::uint32_t u16()
    {
        const std::uint32_t low = u8();
        return low | u8() << 8;
    }

    std::uint32_t u32()
    {
        const std::uint32_t low = u16();
        return low | u16() << 16;
    }

    /// Seven bits a byte, lowest first, the high bit set on all bytes except the last. What does not fit in
    /// 32 bits counts as past the end.
    std::uint32_t varint()
    {
        std::uint32_t value = 0;
        for (int shift = 0; shift < 32; shift += 7) {
            const std::uint32_t byte = u8();
            if (shift == 28 && byte > 0x0F)
                break;
            value |= (byte & 0x7F) << shift;
            if ((byte & 0x80) == 0)
                return value;
        }
        overrun_ = true;
        return 0;
    }

    /// 2 v for v >= 0, -2 v - 1 below.
    std::int32_t signed_varint()
    {
        const std::uint32_t code = varint();
        return static_cast<std::int32_t>(code >> 1 ^ (0U - (code & 1)));
    }

    void skip(std::size_t count)
    {
        overrun_ = overrun_ || count > left();
        at_ += count > left() ? left() : count;
    }

    /// Reads the next `count` bytes on their own, or those that are left.
    ByteReader take(std::size_t count)
    {
        const ByteReader part{rest().first(count < left() ? count : left())};
        skip(count);
        return part;
    }

    /// Rejects what was read as meaningless: it counts as past the end.
    void refuse() { overrun_ = true; }

    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    std::span<const std::byte> rest() const { return {at_, end_}; }
    bool overrun() const { return overrun_; }

private:
    const std::byte* at_ = nullptr;
    const std::byte* end_ = nullptr;
    bool overrun_ = false;
};

/// A name as the format stores it: a byte with its length, and its letters. Borrows the bytes.
inline std::string_view read_name(ByteReader& bytes)
{
    const std::size_t length = bytes.u8();
    const auto* letters = reinterpret_cast<const char*>(bytes.rest().data());
    const std::string_view name{letters, std::min(length, bytes.left())};
    bytes.skip(length);
    return name;
}

/// Reads bits from front to back, the highest bit of each byte first. Past the end it reads zeros, and
/// remembers that it did.
class BitReader {
public:
    /// The maximum number of bits that can be looked at at once.
    static constexpr std::uint32_t max = 25;

    BitReader() = default;
    explicit BitReader(std::span<const std::byte> bytes)
        : bytes_{bytes.data()}, size_{static_cast<std::uint32_t>(std::min(bytes.size(), max_bytes))}
    {
    }

    /// Takes the whole bytes of `count` numbers of `width` bits, at most 64. It may read ahead in what
    /// follows them.
    static BitReader take(ByteReader& bytes, std::uint32_t count, std::uint32_t width);

    /// The next bits, at least `max`, the first one highest.
    std::uint32_t ahead() const
    {
        const std::uint32_t byte = at_ >> 3;
        const std::uint32_t word = byte + 4 <= size_ ? word_at(bytes_ + byte) : last_word(byte);
        return word << (at_ & 7);
    }
    void skip(std::uint32_t count) { at_ += count; }
    /// Goes to the bit `at`, counted from the first one.
    void go_to(std::uint32_t at) { at_ = at; }

    /// The next `count` bits, 1 … `max`.
    std::uint32_t bits(std::uint32_t count)
    {
        expects(count >= 1 && count <= max);
        const std::uint32_t value = ahead() >> (32 - count);
        skip(count);
        return value;
    }
    /// The next `count` bits, 0 … 32.
    std::uint32_t number(std::uint32_t count)
    {
        expects(count <= 32);
        if (count == 0)
            return 0;
        if (count <= max)
            return bits(count);
        const std::uint32_t high = bits(count - 16);
        return high << 16 | bits(16);
    }
    /// The next `count` bits, 1 … `max`, as a signed number; the highest bit is the sign.
    std::int32_t signed_bits(std::uint32_t count)
    {
        expects(count >= 1 && count <= max);
        const std::int32_t value = static_cast<std::int32_t>(ahead()) >> (32 - count);
        skip(count);
        return value;
    }

    /// The bytes from the first one of which no bit has been read.
    std::span<const std::byte> rest() const
    {
        const std::uint32_t read = std::min((at_ + 7) / 8, size_);
        return {bytes_ + read, size_ - read};
    }
    bool overrun() const { return at_ > 8 * size_; }

private:
    static constexpr std::size_t max_bytes = 1U << 28; ///< whose bits can be counted

    static std::uint32_t word_at(const std::byte* at)
    {
        const auto byte = [at](int i) { return std::to_integer<std::uint32_t>(at[i]); };
        return byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
    }

    std::uint32_t last_word(std::uint32_t byte) const;

    const std::byte* bytes_ = nullptr;
    std::uint32_t size_ = 0;
    std::uint32_t at_ = 0; ///< in bits
};

}
