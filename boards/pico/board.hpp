#pragma once

#include "boards/pico/clock.hpp"
#include "boards/pico/computer.hpp"
#include "boards/pico/control_pins.hpp"
#include "boards/pico/dimmer.hpp"
#include "boards/pico/fault_light.hpp"
#include "boards/pico/memory.hpp"
#include "boards/pico/report.hpp"
#include "boards/pico/tearing_line.hpp"
#include "boards/pico/watchdog.hpp"
#include "firmware/board.hpp"
#include "firmware/link/stage.hpp"
#include "firmware/tearing_wait.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A Raspberry Pi Pico with a display, one processor at work. It plays what its stage has, as controls and
/// computer want it, and tells what it does (report.hpp) if the settings name a pin for that. The backlight
/// is dark until a picture has arrived, and while the display rests.
template <class Display>
class Board {
public:
    /// All of them must outlive the board. The computer has begun.
    Board(Display& panel, const BoardSettings& settings, const Clock& clock, const Computer& computer)
        : panel_{panel}, settings_{settings}, clock_{clock}, computer_{computer}, stage_{computer.stage()},
          control_pins_{settings}, light_{settings.pin(PinRole::backlight)}, tearing_line_{settings.pin(
                                                                                 PinRole::tearing)}
    {
    }

    BoardNames names() const { return {"Pico", controller_name(settings_.panel.controller)}; }

    Display& panel() { return panel_; }
    Microseconds now() const { return clock_.now(); }
    void sleep_until(Microseconds moment) { computer_.serve_until(moment); }
    void linger_until(Microseconds moment) { computer_.serve_until_change(moment); }

    std::span<const std::byte> scene_bytes() const { return stage_.scene_bytes(); }
    std::span<std::byte> block() const { return stage_.block(); }
    std::array<std::span<std::byte>, 2> bands() { return memory::bands(); }

    bool wants_to_run() const { return true; }
    bool begin()
    {
        is_faulty_ = false;
        fault_light_.end();
        return is_drawing_ = stage_.begin();
    }
    bool running()
    {
        watchdog::feed();
        if (!is_drawing_)
            stand_by();
        return !stage_.wants_to_begin();
    }
    void listen() { computer_.serve(); }

    void scene_started(const SceneView& scene)
    {
        stage_.scene_started(scene);
        report::scene_started(scene_bytes());
    }
    void event_passed(const EventView& event) { report::event_passed(event.name); }

    void plays(LiveScene* player) { stage_.plays(player); }
    Playhead playhead(const SceneView&) const { return stage_.playhead(); }

    void steer(Playhead& playhead)
    {
        stage_.steer(playhead, control_pins_, now());
        if (stage_.wants_rest())
            light_.set(0);
        else if (stage_.brightness() != brightness_)
            set_brightness(stage_.brightness());
    }

    std::span<const PlacedInput> inputs() const { return stage_.inputs(); }
    bool wants_rest() const { return stage_.wants_rest(); }

    void wait_for_blank()
    {
        if (settings_.panel.tearing_effect)
            tearing_wait_.wait([this] { return tearing_line_.pictures(); },
                               [this] {
                                   computer_.serve();
                                   return now();
                               });
    }

    void frame_shown(FrameReport frame)
    {
        stage_.frame_shown(frame);
        light_.set(brightness_); // not before: until now the display showed whatever it woke up with
        report::frame_shown(frame);
    }

    void fault(Error error)
    {
        stage_.fault();
        is_drawing_ = false;
        is_faulty_ = true;
        fault_light_.begin(now());
        light_.set(brightness_);
        report::fault(error);
    }

private:
    /// While no frames are drawn.
    void stand_by()
    {
        if (is_faulty_)
            fault_light_.pass(now());
        if (stage_.brightness() == brightness_)
            return;
        set_brightness(stage_.brightness());
        light_.set(brightness_);
    }

    void set_brightness(std::uint8_t brightness)
    {
        brightness_ = brightness;
        panel_.set_brightness(brightness);
    }

    Display& panel_;
    const BoardSettings& settings_;
    const Clock& clock_;
    const Computer& computer_;
    link::Stage& stage_;
    ControlPins control_pins_;
    Dimmer light_;
    TearingLine tearing_line_;
    TearingWait tearing_wait_;
    std::uint8_t brightness_ = settings_.panel.brightness;
    FaultLight fault_light_;
    bool is_drawing_ = false;
    bool is_faulty_ = false; ///< what was to be played cannot be
};

}
