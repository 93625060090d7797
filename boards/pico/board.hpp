#pragma once

#include "boards/pico/clock.hpp"
#include "boards/pico/computer.hpp"
#include "boards/pico/control_pins.hpp"
#include "boards/pico/dimmer.hpp"
#include "boards/pico/memory.hpp"
#include "boards/pico/report.hpp"
#include "boards/pico/tearing_line.hpp"
#include "boards/pico/watchdog.hpp"
#include "firmware/board.hpp"
#include "firmware/controls.hpp"
#include "firmware/tearing_wait.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast::pico {

/// A Raspberry Pi Pico with a display, one processor at work. It plays the scene that lies in flash from
/// 0x1004'0000 on, as its controls have it, and tells what it does (report.hpp) if the settings name a pin
/// for that. The backlight is dark until a picture has arrived, and while the display rests.
template <class Display>
class Board {
public:
    /// All of them must outlive the board.
    Board(Display& panel, const BoardSettings& settings, const Clock& clock, Computer& computer)
        : panel_{panel}, settings_{settings}, clock_{clock}, computer_{computer}, control_pins_{settings},
          light_{settings.pin(PinRole::backlight)}, tearing_line_{settings.pin(PinRole::tearing)}
    {
    }

    BoardNames names() const { return {"Pico", controller_name(settings_.panel.controller)}; }

    /// Whether there is something to run, for the first time or again.
    bool wants_to_run() const { return wants_to_run_; }

    Display& panel() { return panel_; }
    Microseconds now() const { return clock_.now(); }
    void sleep_until(Microseconds moment) { computer_.serve_until(moment, clock_); }

    std::span<const std::byte> scene_bytes() { return memory::scene_region(); }
    std::span<std::byte> block() { return memory::player_block(); }
    std::array<std::span<std::byte>, 2> bands() { return memory::bands(); }

    bool running()
    {
        watchdog::feed();
        report_dropped();
        return true;
    }
    void listen() { computer_.serve(); }

    void scene_started(const SceneView& scene) { report::scene_started(scene_bytes().first(scene.size())); }
    void event_passed(const EventView& event) { report::event_passed(event.name); }

    Playhead playhead(const SceneView& scene)
    {
        controls_.emplace(settings_, scene);
        return controls_->playhead();
    }

    void steer(Playhead& playhead)
    {
        controls_->steer(playhead, control_pins_, now());
        if (controls_->wants_rest())
            light_.set(0);
        else if (controls_->brightness() != brightness_)
            set_brightness(controls_->brightness());
    }

    std::span<const PlacedInput> inputs() const { return controls_->inputs(); }
    bool wants_rest() const { return controls_->wants_rest(); }

    void wait_for_blank()
    {
        if (settings_.panel.tearing_effect)
            tearing_wait_.wait([this] { return tearing_line_.pictures(); }, [this] { return now(); });
    }

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
    void report_dropped()
    {
        if (const std::uint32_t dropped = computer_.dropped(); dropped != told_dropped_)
            report::reports_dropped(told_dropped_ = dropped);
    }

    void set_brightness(std::uint8_t brightness)
    {
        brightness_ = brightness;
        panel_.set_brightness(brightness);
    }

    Display& panel_;
    const BoardSettings& settings_;
    const Clock& clock_;
    Computer& computer_;
    ControlPins control_pins_;
    Dimmer light_;
    TearingLine tearing_line_;
    TearingWait tearing_wait_;
    std::optional<Controls> controls_; ///< of the scene that is played
    std::uint8_t brightness_ = settings_.panel.brightness;
    std::uint32_t told_dropped_ = 0;
    bool wants_to_run_ = true;
};

}
