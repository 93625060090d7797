#pragma once

#include "firmware/slots/flash_places.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast::test {

inline constexpr std::uint32_t pool_sectors = 12;
/// A sector that belongs to others, two of the directory, the pool, two of the directory, and one more sector
/// of others.
inline constexpr FlashPlaces small_places{
    .directory = sector_bytes, .pool = 3 * sector_bytes, .pool_bytes = pool_sectors * sector_bytes};
inline constexpr std::size_t small_flash_bytes = (3 + pool_sectors + 2 + 1) * sector_bytes;

}
