#include "core/bytes/crc32.hpp"

#include <array>

namespace kfast {
namespace {

// One entry per half byte: 64 bytes of flash instead of 1 KiB, twice the steps.
constexpr std::array<std::uint32_t, 16> nibble_table = [] {
    std::array<std::uint32_t, 16> table{};
    for (std::uint32_t nibble = 0; nibble < table.size(); ++nibble) {
        std::uint32_t rest = nibble;
        for (int bit = 0; bit < 4; ++bit)
            rest = (rest >> 1) ^ ((rest & 1) != 0 ? 0xEDB88320 : 0);
        table[nibble] = rest;
    }
    return table;
}();

}

void Crc32::add(std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes) {
        state_ ^= std::to_integer<std::uint32_t>(byte);
        state_ = (state_ >> 4) ^ nibble_table[state_ & 15];
        state_ = (state_ >> 4) ^ nibble_table[state_ & 15];
    }
}

}
