#pragma once

#include <array>
#include <cstddef>
#include <span>

/// What the board lends, and what its flash holds.
namespace kfast::pico::memory {

/// All RAM that the image leaves.
std::span<std::byte> player_block();
/// 24 rows of 320 colours each, 32 of 240.
std::array<std::span<std::byte>, 2> bands();
/// Where the built-in scene is: 256 KiB of flash.
std::span<const std::byte> scene_region();

}
