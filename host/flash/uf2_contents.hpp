#pragma once

#include "host/flash/flash_image.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// What is wrong with a block of a UF2 file. Blocks are counted from 0 on, in their order in the file.
struct Uf2Mistake {
    std::size_t block = 0;
    std::string reason; ///< "its address 0x10000180 is no multiple of 256"
};

/// The part of a UF2 file for one family of chips.
struct Uf2Part {
    std::optional<std::uint32_t> family; ///< none: the blocks do not say
    std::size_t first_block = 0;
    std::size_t blocks = 0;
    std::uint32_t flags = 0;          ///< of all its blocks together
    std::vector<FlashRegion> regions; ///< in the order of addresses, neighbours joined
};

struct Uf2Contents {
    std::size_t blocks = 0;
    std::vector<Uf2Part> parts;       ///< in the order in which they begin
    std::vector<Uf2Mistake> mistakes; ///< in the order of blocks
};

/// Reads any bytes. Blocks with mistakes may be missing in `parts`. A mistake is what keeps a boot loader
/// from writing a block or knowing when the file is complete: blocks of a family that are missing or not in
/// their order, two that write to one address, and, for the RP2040, all that its boot ROM leaves out.
Uf2Contents read_uf2(std::span<const std::byte> file);

}
