#pragma once

#include "boards/pico/clock.hpp"
#include "boards/pico/dimmer.hpp"
#include "boards/pico/memory.hpp"
#include "boards/pico/report.hpp"
#include "boards/pico/watchdog.hpp"
#include "firmware/board.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A Raspberry Pi Pico with a display, one processor at work. It plays the scene that lies in flash from
/// 0x1004'0000 on, and tells what it does (report.hpp) if the settings name a pin for that.
template <class Display>
class Board {
public:
    /// `panel` and `clock` must outlive the board.
    Board(Display& panel, const BoardSettings& settings, const Clock& clock)
        : panel_{panel}, clock_{clock}, light_{settings.pin(PinRole::backlight)},
          brightness_{settings.panel.brightness}
    {
    }

    /// Whether there is something to run, for the first time or again.
    bool wants_to_run() const { return wants_to_run_; }

    Display& panel() { return panel_; }
    Microseconds now() const { return clock_.now(); }
    void sleep_until(Microseconds moment) { clock_.sleep_until(moment); }

    std::span<const std::byte> scene_bytes() { return memory::scene_region(); }
    std::span<std::byte> block() { return memory::player_block(); }
    std::array<std::span<std::byte>, 2> bands() { return memory::bands(); }

    bool running()
    {
        watchdog::feed();
        return true;
    }

    void scene_started(const SceneView& scene) { report::scene_started(scene_bytes().first(scene.size())); }
    void event_passed(const EventView& event) { report::event_passed(event.name); }

    void frame_shown(FrameReport frame)
    {
        light_.set(brightness_); // not before: until now the display showed whatever it woke up with
        report::frame_shown(frame);
    }

    void fault(Error error)
    {
        light_.set(brightness_);
        report::fault(error);
        wants_to_run_ = false;
    }

private:
    Display& panel_;
    const Clock& clock_;
    Dimmer light_;
    std::uint8_t brightness_;
    bool wants_to_run_ = true;
};

}
