#include "host/flash/boot_checksum.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace kfast {
namespace {

constexpr std::size_t summed_bytes = 252;

std::uint32_t shifted_by_a_byte(std::uint32_t state)
{
    for (int bit = 0; bit < 8; ++bit)
        state = state << 1 ^ ((state >> 31) != 0 ? 0x04C1'1DB7U : 0U);
    return state;
}

}

std::uint32_t boot_checksum(std::span<const std::byte> bytes)
{
    std::uint32_t state = 0xFFFF'FFFF;
    for (const std::byte byte : bytes)
        state = shifted_by_a_byte(state ^ std::to_integer<std::uint32_t>(byte) << 24);
    return state;
}

BootBlock with_boot_checksum(std::span<const std::byte> code)
{
    if (code.size() > summed_bytes)
        throw std::invalid_argument{"the code of a boot block has at most 252 bytes; this has " +
                                    std::to_string(code.size())};
    BootBlock block{};
    std::ranges::copy(code, block.begin());
    std::uint32_t sum = boot_checksum(std::span{block}.first(summed_bytes));
    for (std::byte& byte : std::span{block}.subspan(summed_bytes)) {
        byte = static_cast<std::byte>(sum & 0xFF);
        sum >>= 8;
    }
    return block;
}

}
