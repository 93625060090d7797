#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

inline constexpr std::uint32_t sector_bytes = 4096;
inline constexpr std::uint32_t page_bytes = 256;

/// `bytes` rounded up to whole sectors.
constexpr std::uint32_t whole_sectors(std::uint32_t bytes)
{
    return (bytes + sector_bytes - 1) / sector_bytes * sector_bytes;
}

// Compound requirements would be torn apart.
// clang-format off

/// NOR flash that can be read like memory. Offsets count from its beginning. Whether a call has succeeded
/// is checked by reading.
template <class F>
concept Flash = requires(F& flash, const F& same, std::uint32_t offset, std::span<const std::byte, page_bytes> page) {
    /// Fills the sector at `offset`, a multiple of sector_bytes, with 0xFF.
    { flash.erase(offset) } -> std::same_as<void>;
    /// Writes a page, which was erased before, at `offset`, a multiple of page_bytes. `page` is in RAM.
    { flash.program(offset, page) } -> std::same_as<void>;
    { same.contents() } -> std::same_as<std::span<const std::byte>>;
};

// clang-format on

}
