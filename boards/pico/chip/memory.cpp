#include "boards/pico/chip/memory.hpp"

#include "core/pixel/pixel_format.hpp"

extern "C" {
// From the linker script.
extern std::byte player_block_begin[];
extern std::byte player_block_end[];
extern const std::byte scene_region_begin[];
extern const std::byte scene_region_end[];
}

namespace kfast::pico::memory {
namespace {

constexpr std::size_t band_bytes = 24 * row_bytes(PixelFormat::rgb565, 320);

alignas(4) std::array<std::array<std::byte, band_bytes>, 2> band_buffers;

}

std::span<std::byte> player_block() { return {player_block_begin, player_block_end}; }

std::array<std::span<std::byte>, 2> bands() { return {band_buffers[0], band_buffers[1]}; }

std::span<const std::byte> scene_region() { return {scene_region_begin, scene_region_end}; }

}
