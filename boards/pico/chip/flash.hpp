#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Changes flash by the functions of the boot ROM. No interrupt is served meanwhile, and nothing may read
/// flash: no DMA, and not the other processor. Offsets count from the beginning of flash.
namespace kfast::pico::flash {

inline constexpr std::size_t sector_bytes = 4096;
inline constexpr std::size_t page_bytes = 256;

/// Fills sectors with 0xFF: about 45 ms, at worst 400 ms each; the watchdog is fed before each. Both numbers
/// are multiples of sector_bytes, or nothing is done and the board stops with a fault.
void erase(std::uint32_t offset, std::size_t count);

/// Writes pages, which were erased before. `bytes` is in RAM; the offset and its size are multiples of
/// page_bytes, or nothing is done and the board stops with a fault.
void program(std::uint32_t offset, std::span<const std::byte> bytes);

/// All of it.
std::span<const std::byte> contents();

inline constexpr std::size_t unique_id_bytes = 8;
using UniqueId = std::array<std::byte, unique_id_bytes>;

/// The number that the flash chip was made with: no other chip has the same.
UniqueId unique_id();

}
