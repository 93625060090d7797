#include "boards/lm3s6965evb/board.hpp"

#include "boards/lm3s6965evb/clocks.hpp"
#include "boards/lm3s6965evb/uart.hpp"
#include "core/crc32.hpp"
#include "core/error_text.hpp"
#include "firmware/panel_mirror.hpp"
#include "firmware/version.hpp"

#include <cstdint>

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
constexpr std::size_t band_bytes = band_rows * row_bytes(PixelFormat::grey4, 128);

alignas(4) std::array<std::byte, 32 * 1024> player_block;
alignas(4) std::array<std::array<std::byte, band_bytes>, 2> band_buffers;
PanelMirror<PixelFormat::grey4, 128, 64> mirror;

/// Told by the magic alone: run() reads the rest.
bool holds_scene(std::span<const std::byte> bytes)
{
    const auto beginning = SceneView::parse(bytes.first(4));
    return beginning || beginning.error() != Error::bad_magic;
}

}

Board::Board()
{
    start_clocks();
    uart::begin();
    clock_.begin();
    bus_.begin();
    uart::write("KFAST ");
    uart::write(version);
    uart::write(" lm3s6965evb ssd0323 128x64 grey4\n");
}

Microseconds Board::now() const { return mode_ == Mode::stepped ? stepped_clock_ : clock_.now(); }

void Board::sleep_until(Microseconds moment)
{
    if (mode_ != Mode::stepped)
        return clock_.sleep_until(moment);
    if (frame_stands_)
        obey(uart::read());
    frame_stands_ = false;
    stepped_clock_ = moment;
}

std::span<const std::byte> Board::scene_bytes()
{
    const std::span region{scene_region_begin, scene_region_end};
    const std::span linked{linked_scene_begin, linked_scene_end};
    return linked.empty() || holds_scene(region) ? region : linked;
}

std::span<std::byte> Board::block() { return player_block; }

std::array<std::span<std::byte>, 2> Board::bands() { return {band_buffers[0], band_buffers[1]}; }

bool Board::running()
{
    if (mode_ != Mode::free_running || !uart::pending())
        return mode_ != Mode::ended;
    const char wish = uart::read();
    obey(wish);
    if (wish != 's')
        return mode_ != Mode::ended;
    mode_ = Mode::stepped;
    uart::write("STEP\n");
    return false; // to be run again from the first frame
}

void Board::scene_started(const SceneView& scene)
{
    Crc32 bytes;
    bytes.add(scene_bytes().first(scene.size()));
    uart::write("SCENE ");
    uart::write_decimal(scene.size());
    uart::write(' ');
    uart::write_hex(bytes.value());
    uart::write('\n');
}

void Board::event_passed(const EventView& event)
{
    uart::write("EVENT ");
    uart::write(event.name);
    uart::write('\n');
}

void Board::watch(Rect area, std::span<const std::byte> pixels)
{
    mirror.take(area, pixels);
    bytes_sent_ += static_cast<std::uint32_t>(pixels.size()) + Ssd0323<Ssi>::window_bytes;
}

void Board::frame_shown(FrameReport report)
{
    uart::write("F ");
    uart::write_decimal(static_cast<std::uint32_t>(report.time.ticks));
    uart::write(' ');
    uart::write_hex(mirror.hash());
    uart::write(' ');
    uart::write_decimal(std::exchange(bytes_sent_, 0));
    uart::write('\n');
    frame_stands_ = mode_ == Mode::stepped;
}

void Board::fault(Error error)
{
    uart::write("ERROR ");
    uart::write(error_text(error));
    uart::write('\n');
    mode_ = Mode::ended;
}

void Board::obey(char wish)
{
    if (wish == 'q')
        end();
    if (wish == 'r')
        wants_redraw_ = true;
}

void Board::end()
{
    uart::write("END\n");
    mode_ = Mode::ended;
}

}
