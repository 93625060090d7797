#pragma once

#include "host/flash/flash_image.hpp"
#include "host/flash/uf2_contents.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// Part of the contents of the flash of a Pico.
struct FlashPiece {
    FlashRegion region;
    std::string words; ///< "settings of a display st7789, 240 x 320, on spi"; empty if not known
};

/// Regions, cut where another part of KFAST begins. A known part ends at its own end, without the padding
/// after it.
std::vector<FlashPiece> flash_pieces(std::span<const FlashRegion> regions);

/// What a UF2 file has. Throws Failure when it cannot be read, or with all blocks that are wrong and what is
/// wrong with them.
Uf2Contents load_uf2(const std::filesystem::path& path);

/// "RP2040 (0xe48bff56)", "0x12345678", "unknown chips"
std::string chips_of(const Uf2Part& part);

/// Its regions; what KFAST knows is cut out of them where they are for the RP2040.
std::vector<FlashPiece> pieces_of(const Uf2Part& part);

}
