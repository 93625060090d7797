#pragma once

#include "host/flash/flash_region.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// What every such file begins with.
inline constexpr std::string_view uf2_magic = "UF2\n";

/// What tells the boot loaders of different chips which files are theirs.
inline constexpr std::uint32_t rp2040_family = 0xE48B'FF56;

/// A file that a boot loader with a drive (BOOTSEL) writes to flash: whole sectors of 4 KiB in the order of
/// their addresses, padded with 0xFF, each in 16 blocks whose numbers begin at a multiple of 16. The boot ROM
/// of the RP2040 counts on that: it erases a sector when such a number comes. Sectors that no region touches
/// stay as they are.
///
/// Throws std::invalid_argument when a sector belongs to two regions or a region ends beyond 32 bits.
std::vector<std::byte> uf2_of(std::span<const FlashRegion> regions, std::uint32_t family = rp2040_family);

/// What such a file writes, in the order of addresses, neighbours joined. The padding is part of it.
///
/// Throws std::invalid_argument, naming the first block that is wrong and the reason (uf2_contents.hpp), also
/// when one is for another family.
std::vector<FlashRegion> regions_of(std::span<const std::byte> file, std::uint32_t family = rp2040_family);

}
