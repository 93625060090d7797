#pragma once

#include "firmware/settings/rp2040_flash.hpp"

#include <cstddef>
#include <cstdint>

/// The layout of the flash of a Pico: firmware, then the sector of the settings, then the built-in scene,
/// and after it the slots.
namespace kfast::pico_flash {

inline constexpr std::uint32_t begin = 0x1000'0000;
inline constexpr std::uint32_t settings = begin + 0x3'F000;
inline constexpr std::uint32_t scene = begin + rp2040::built_in_scene;
inline constexpr std::uint32_t scene_end = scene + rp2040::built_in_bytes;
inline constexpr std::size_t sector_bytes = 4096; ///< that are erased at once

}
