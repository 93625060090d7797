#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/flash/flash_image.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// A block of a UF2 file, the fields as they are stored.
struct Uf2Block {
    static constexpr std::size_t bytes = 512;
    static constexpr std::size_t payload_room = 476;
    static constexpr std::size_t payload_size = 256; ///< the only one that the RP2040 takes
    static constexpr std::size_t per_sector = FlashImage::sector_bytes / payload_size;

    /// Flags.
    static constexpr std::uint32_t not_for_flash = 0x1;
    static constexpr std::uint32_t holds_files = 0x1000;
    static constexpr std::uint32_t names_family = 0x2000;

    std::uint32_t flags = names_family;
    std::uint32_t address = 0;
    std::uint32_t payload_bytes = payload_size; ///< as given in the block
    std::uint32_t number = 0;
    std::uint32_t count = 0;              ///< of blocks of the file
    std::uint32_t family = 0;             ///< if the flags say so: otherwise the size of the file
    std::span<const std::byte> payload{}; ///< as much of it as a block has room for
};

/// The result refers to `bytes`. None if they do not begin and end as a block.
std::optional<Uf2Block> read_uf2_block(std::span<const std::byte, Uf2Block::bytes> bytes);

/// Writes zeros after the payload.
void write_uf2_block(ByteWriter& file, const Uf2Block& block);

/// The Uf2Block::per_sector blocks of a sector. `first` has the number of the first one, the count and the
/// family.
void write_uf2_sector(ByteWriter& file, const FlashImage::Sector& sector, const Uf2Block& first);

/// The beginning of every such file.
inline constexpr std::string_view uf2_magic = "UF2\n";

/// Identifies the files for the boot loader of a chip.
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
/// Throws std::invalid_argument, naming the first invalid block and the reason (uf2_contents.hpp), also
/// when one is for another family.
std::vector<FlashRegion> regions_of(std::span<const std::byte> file, std::uint32_t family = rp2040_family);

}
