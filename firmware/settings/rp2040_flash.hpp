#pragma once

#include "firmware/slots/flash_places.hpp"

#include <cstdint>

/// How the 2 MiB of flash of a Raspberry Pi Pico are divided after the sector of its settings
/// (docs/link.md).
namespace kfast::rp2040 {

inline constexpr std::uint32_t flash_bytes = 0x200000;

/// The built-in scene, which a UF2 file brings.
inline constexpr std::uint32_t built_in_scene = 0x040000;
inline constexpr std::uint32_t built_in_bytes = 0x040000;

inline constexpr FlashPlaces slot_places{
    .directory = 0x080000,
    .pool = 0x082000,
    .pool_bytes = 0x17C000,
};

static_assert(built_in_scene + built_in_bytes == slot_places.directory);
static_assert(slot_places.directory + 2 * sector_bytes == slot_places.pool);
static_assert(slot_places.pool + slot_places.former_pool_bytes() == flash_bytes);

}
