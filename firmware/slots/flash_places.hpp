#pragma once

#include "firmware/slots/flash.hpp"

#include <cstdint>

namespace kfast {

/// Where the slots of a device are in its flash, in whole sectors.
struct FlashPlaces {
    static constexpr std::uint32_t directory_sectors = 4;

    std::uint32_t directory = 0;  ///< its first two sectors; the other two follow the pool
    std::uint32_t pool = 0;       ///< in which the scenes are
    std::uint32_t pool_bytes = 0; ///< with two sectors more it is at most SectorSet::capacity of them

    /// Where a sector of the directory is; `number` is less than `directory_sectors`.
    constexpr std::uint32_t directory_sector(std::uint32_t number) const
    {
        return number < 2 ? directory + number * sector_bytes
                          : pool + pool_bytes + (number - 2) * sector_bytes;
    }
    /// The pool as it was when a directory had two sectors. A scene that was stored then may reach into the
    /// sectors that follow the pool now.
    constexpr std::uint32_t former_pool_bytes() const { return pool_bytes + 2 * sector_bytes; }
};

}
