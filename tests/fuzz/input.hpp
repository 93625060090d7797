#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// The bytes of a fuzzer, one after the other; behind their end are zeros.
class FuzzInput {
public:
    explicit FuzzInput(std::span<const std::byte> bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.empty(); }

    std::uint8_t u8()
    {
        const auto byte = take(1);
        return byte.empty() ? std::uint8_t{0} : std::to_integer<std::uint8_t>(byte[0]);
    }
    std::uint16_t u16()
    {
        const std::uint32_t low = u8();
        return static_cast<std::uint16_t>(low | std::uint32_t{u8()} << 8);
    }
    std::uint32_t u32()
    {
        const std::uint32_t low = u16();
        return low | std::uint32_t{u16()} << 16;
    }
    /// Less than `end`, which is not 0.
    std::uint8_t below(std::uint32_t end) { return static_cast<std::uint8_t>(u8() % end); }
    bool flag() { return u8() % 2 != 0; }

    /// `count` bytes, or as many as are left.
    std::span<const std::byte> take(std::size_t count)
    {
        const auto taken = bytes_.first(std::min(count, bytes_.size()));
        bytes_ = bytes_.subspan(taken.size());
        return taken;
    }

private:
    std::span<const std::byte> bytes_;
};

}
