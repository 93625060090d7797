#pragma once

#include "firmware/panel/ssd0323.hpp"
#include "firmware/run/board.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <array>
#include <cstddef>
#include <span>

extern "C" {
// From the linker script.
extern const std::byte scene_region_begin[];
extern const std::byte scene_region_end[];
}

namespace kfast::board_template {

/// The wires to the display.
class Bus {
public:
    /// Start the clock of the bus unit, give it its pins and its speed, make D/C an output.
    void begin() {}

    /// D/C low, send all bytes, wait until the last bit is out.
    void command(std::span<const std::byte>) {}

    /// The same with D/C high.
    void parameters(std::span<const std::byte>) {}

    /// D/C high, start a DMA transfer (or an interrupt that feeds the FIFO) and return.
    void start_data(std::span<const std::byte>) {}

    /// Whether the transfer that start_data() began is still going on, to the last bit.
    bool busy() const { return false; }
};

class Board {
public:
    /// Set the system clock; begin the timer and the bus; reset the display if it has a reset pin.
    Board() { bus_.begin(); }

    /// The display: choose its driver from firmware/panel/, and say below how its glass is made and rotated.
    Ssd0323<Bus>& panel() { return panel_; }

    /// Read a timer that counts microseconds in 32 bits and wraps.
    Microseconds now() const { return {}; }

    /// Wait, best asleep, until reached(now(), moment).
    void sleep_until(Microseconds) {}

    /// Where the scene is in flash: a region of its own, as link.ld has it, or an array that is linked in.
    std::span<const std::byte> scene_bytes() { return {scene_region_begin, scene_region_end}; }

    /// What it has of the player: all, or only what its scenes need (`kfast info`), as in
    /// static constexpr Features needed{.strokes = &kfast_strokes, .tweens = &kfast_tweens}, so that the rest
    /// takes no flash.
    const Features& features() const { return every_feature; }

    /// As much RAM as the largest scene needs that the board is to play.
    std::span<std::byte> block() { return block_; }

    /// Eight rows each are plenty: more rows make fewer bands, not a faster picture.
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }

    /// False ends the loop: a button, a command, another scene.
    bool running() { return true; }

    /// The scene was accepted. Say so, or do nothing.
    void scene_started(const SceneView&) {}

    /// A frame is on the display. Say so, or do nothing.
    void frame_shown(FrameReport) {}

    /// There is nothing to play, and the display says why. Blink, or write error_text(error) to a serial
    /// port.
    void fault(Error) {}

private:
    static constexpr int band_rows = 8;
    static constexpr std::size_t band_bytes = band_rows * row_bytes(Ssd0323<Bus>::format, 128);

    alignas(4) static inline std::array<std::byte, 16 * 1024> block_;
    alignas(4) static inline std::array<std::array<std::byte, band_bytes>, 2> bands_;
    Bus bus_;
    Ssd0323<Bus> panel_{bus_, facts_of(Controller::ssd0323).default_value};
};

static_assert(kfast::PanelBoard<Board>);

}
