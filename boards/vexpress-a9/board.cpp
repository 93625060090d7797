#include "boards/vexpress-a9/board.hpp"

extern "C" {
// From the linker script.
extern const std::byte scene_region_begin[];
extern const std::byte scene_region_end[];
}

namespace kfast::vexpress_a9 {
namespace {

constexpr std::size_t band_rows = 8;
constexpr std::size_t band_bytes = band_rows * row_bytes(Framebuffer::format, glass.width);

alignas(4) std::array<std::byte, 512 * 1024> player_block;
alignas(4) std::array<std::array<std::byte, band_bytes>, 2> band_buffers;

}

Board::Board() : ConsoleBoard{uart}
{
    uart.begin(uart_divisor);
    begin("vexpress-a9 pl111 " KFAST_GLASS " rgb565");
}

std::span<const std::byte> Board::scene_bytes() { return {scene_region_begin, scene_region_end}; }

std::span<std::byte> Board::block() { return player_block; }

std::array<std::span<std::byte>, 2> Board::bands() { return {band_buffers[0], band_buffers[1]}; }

}
