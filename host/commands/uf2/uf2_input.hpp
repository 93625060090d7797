#pragma once

#include "host/commands/uf2/flash_piece.hpp"
#include "host/flash/uf2_contents.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace kfast {

/// What a UF2 file has. Throws Failure when it cannot be read, or with all blocks that are wrong and what is
/// wrong with them.
Uf2Contents load_uf2(const std::filesystem::path& path);

/// "RP2040 (0xe48bff56)", "0x12345678", "unknown chips"
std::string chips_of(const Uf2Part& part);

/// Its regions; what KFAST knows is cut out of them where they are for the RP2040.
std::vector<FlashPiece> pieces_of(const Uf2Part& part);

}
