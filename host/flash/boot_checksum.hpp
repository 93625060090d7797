#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// CRC-32/MPEG-2: polynomial 0x04C1'1DB7, begun with ones, neither reflected nor inverted in the end. By it
/// the RP2040 distinguishes a boot block from other bytes.
std::uint32_t boot_checksum(std::span<const std::byte> bytes);

/// The first page of flash as the boot ROM of the RP2040 requires it: 252 bytes, and their checksum with its
/// low byte first.
using BootBlock = std::array<std::byte, 256>;

/// `code` and zeros after it. Throws std::invalid_argument when it is longer than 252 bytes.
BootBlock with_boot_checksum(std::span<const std::byte> code);

}
