#pragma once

#include "firmware/slots/slot_directory.hpp"
#include "tests/firmware/slots/padded_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::test {

inline constexpr std::size_t first_version_bytes = slot_directory_bytes - SectorSet::capacity / 8;

/// A directory as firmware stored it that had two copies and knew of no bad sectors.
inline SlotDirectoryPages first_version_of(const SlotDirectory& directory)
{
    SlotDirectoryPages pages = slot_directory_pages_of(directory);
    pages[4] = std::byte{1};
    pages[17] = std::byte{0};
    const std::uint32_t crc = crc_of(std::span{pages}.first(first_version_bytes - 4));
    std::fill(pages.begin() + first_version_bytes - 4, pages.end(), std::byte{0xFF});
    for (std::size_t byte = 0; byte < 4; ++byte)
        pages[first_version_bytes - 4 + byte] = static_cast<std::byte>(crc >> 8 * byte & 255);
    return pages;
}

}
