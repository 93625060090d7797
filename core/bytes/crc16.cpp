#include "core/bytes/crc16.hpp"

namespace kfast {

// Bit by bit: a table would be larger than what it is for.
std::uint16_t crc16(std::span<const std::byte> bytes)
{
    std::uint32_t rest = 0xFFFF;
    for (const std::byte byte : bytes) {
        rest ^= std::to_integer<std::uint32_t>(byte) << 8;
        for (int bit = 0; bit < 8; ++bit)
            rest = (rest << 1) ^ ((rest & 0x8000) != 0 ? 0x11021 : 0);
    }
    return static_cast<std::uint16_t>(rest);
}

}
