#include "boards/lm3s6965evb/board.hpp"

#include "boards/lm3s6965evb/clocks.hpp"

extern "C" {
// From the linker script.
extern const std::byte scene_region_begin[];
extern const std::byte scene_region_end[];
extern const std::byte linked_scene_begin[];
extern const std::byte linked_scene_end[];
}

namespace kfast::lm3s6965evb {
namespace {

constexpr std::size_t band_rows = 8;
constexpr std::size_t band_bytes = band_rows * row_bytes(Display::format, glass.width);

alignas(4) std::array<std::byte, 32 * 1024> player_block;
alignas(4) std::array<std::array<std::byte, band_bytes>, 2> band_buffers;

/// Checks only the magic: run() reads the rest.
bool holds_scene(std::span<const std::byte> bytes)
{
    const auto beginning = SceneView::parse(bytes.first(4), every_feature_but_outlines);
    return beginning || beginning.error() != Error::bad_magic;
}

}

Board::Board() : ConsoleBoard{uart}
{
    start_clocks();
    start_uart();
    bus_.begin();
    begin("lm3s6965evb ssd0323 128x64 grey4");
}

std::span<const std::byte> Board::scene_bytes()
{
    const std::span region{scene_region_begin, scene_region_end};
    const std::span linked{linked_scene_begin, linked_scene_end};
    return linked.empty() || holds_scene(region) ? region : linked;
}

std::span<std::byte> Board::block() { return player_block; }

std::array<std::span<std::byte>, 2> Board::bands() { return {band_buffers[0], band_buffers[1]}; }

}
