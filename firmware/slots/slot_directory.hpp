#pragma once

#include "firmware/chip/stored_text.hpp"
#include "firmware/slots/flash.hpp"
#include "firmware/slots/sector_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

using SceneName = StoredText<24>;

/// A scene in flash, or none.
struct SlotEntry {
    SceneName name{};
    std::uint32_t offset = 0; ///< in the pool, a multiple of sector_bytes
    std::uint32_t size = 0;   ///< bytes; 0: the slot is empty
    std::uint32_t crc = 0;    ///< CRC-32 of all bytes

    constexpr bool is_empty() const { return size == 0; }
    friend constexpr bool operator==(const SlotEntry&, const SlotEntry&) = default;
};

/// The contents of the slots, and which sectors of the flash do not hold what they are given. Several copies
/// are in flash, and the newest one counts.
struct SlotDirectory {
    static constexpr std::uint8_t slot_count = 8;
    static constexpr std::uint8_t none = 0xFF;

    std::uint32_t generation = 0; ///< one more than that of the copy before; wraps
    std::uint8_t chosen = none;   ///< what plays when the device starts; none: the built-in scene
    std::uint32_t next = 0;       ///< in the pool, after what was written last
    std::uint8_t bad_copies = 0;  ///< a bit for each sector of the directory that does not hold its copy
    SectorSet bad_sectors{};      ///< of the pool
    std::array<SlotEntry, slot_count> slots{};

    friend constexpr bool operator==(const SlotDirectory&, const SlotDirectory&) = default;
};

/// The directory as it is stored in flash, little-endian:
///
///     "KFSD"  version u16 (2)  slots u16
///     generation u32  next u32  chosen u8  bad copies u8  0 u8 x 2
///     slots: name 24 bytes, offset u32, size u32, CRC-32 u32
///     bad sectors: a bit for each sector, 64 bytes
///     CRC-32 of all that, u32
///     0xFF up to the end of the page
///
/// Version 1 has neither bad copies nor bad sectors.
inline constexpr std::size_t slot_directory_bytes =
    8 + 12 + SlotDirectory::slot_count * 36 + SectorSet::capacity / 8 + 4;
inline constexpr std::size_t slot_directory_pages = (slot_directory_bytes + page_bytes - 1) / page_bytes;
using SlotDirectoryPages = std::array<std::byte, slot_directory_pages * page_bytes>;

SlotDirectoryPages slot_directory_pages_of(const SlotDirectory& directory);

/// The directory of a copy of version 1 or 2; none if it is damaged, of another version, or missing, or if a
/// scene would not be in a pool of `pool_bytes`. More bytes may follow.
std::optional<SlotDirectory> read_slot_directory(std::span<const std::byte> bytes, std::uint32_t pool_bytes);

/// Whether `a` was written after `b`. Both are of one history, with less than 2^31 changes between them.
constexpr bool is_newer(const SlotDirectory& a, const SlotDirectory& b)
{
    return a.generation != b.generation && a.generation - b.generation < 0x8000'0000;
}

}
