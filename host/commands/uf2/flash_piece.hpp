#pragma once

#include "host/flash/flash_region.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast {

/// Part of what lies in the flash of a Pico.
struct FlashPiece {
    FlashRegion region;
    std::string words; ///< "settings of a display st7789, 240 x 320, on spi"; empty if nobody knows
};

/// Regions, cut where KFAST begins something else. What is known ends where it does, without the padding
/// behind it.
std::vector<FlashPiece> flash_pieces(std::span<const FlashRegion> regions);

}
