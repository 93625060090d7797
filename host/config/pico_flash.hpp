#pragma once

#include <cstddef>
#include <cstdint>

/// Who lives where in the flash of a Pico: firmware, then the sector of the settings, then the scene.
namespace kfast::pico_flash {

inline constexpr std::uint32_t begin = 0x1000'0000;
inline constexpr std::uint32_t settings = begin + 0x3'F000;
inline constexpr std::uint32_t scene = begin + 0x4'0000;
inline constexpr std::uint32_t end = begin + 0x20'0000;
inline constexpr std::size_t sector_bytes = 4096; ///< that are erased at once

}
