#pragma once

#include "boards/pico/app/control_pins.hpp"
#include "boards/pico/app/fault_light.hpp"
#include "boards/pico/app/report.hpp"
#include "boards/pico/chip/clock.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "boards/pico/usb/computer.hpp"
#include "firmware/link/playback_session.hpp"
#include "firmware/run/board.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A Raspberry Pi Pico, one processor in use, whatever display it has. It plays what its stage has, as
/// controls and computer command, and reports what it does (report.hpp) if the settings name a pin for that.
class PlaybackBoard {
public:
    /// All of them must outlive the board. The computer has begun.
    PlaybackBoard(const BoardSettings& settings, const Clock& clock, const Computer& computer)
        : clock_{clock}, computer_{computer}, playback_{computer.playback()}, control_pins_{settings}
    {
    }

    Microseconds now() const { return clock_.now(); }
    void sleep_until(Microseconds moment) { computer_.serve_until(moment); }
    void linger_until(Microseconds moment) { computer_.serve_until_change(moment); }

    std::span<const std::byte> scene_bytes() const { return playback_.scene_bytes(); }
    std::span<std::byte> block() const { return playback_.block(); }

    bool wants_to_run() const { return true; }
    bool begin()
    {
        is_faulty_ = false;
        fault_light_.end();
        return is_drawing_ = playback_.begin();
    }
    bool running()
    {
        watchdog::feed();
        if (is_faulty_)
            fault_light_.pass(now());
        return !playback_.wants_to_begin();
    }
    void listen() { computer_.serve(); }

    void scene_started(const SceneView& scene)
    {
        playback_.scene_started(scene);
        report::scene_started(scene_bytes());
    }
    void event_passed(const EventView& event) { report::event_passed(event.name); }

    void plays(SceneState* player) { playback_.plays(player); }
    Playhead playhead(const SceneView&) const { return playback_.playhead(); }
    void steer(Playhead& playhead) { playback_.steer(playhead, control_pins_, now()); }

    std::span<const PlacedInput> inputs() const { return playback_.inputs(); }
    bool wants_rest() const { return playback_.wants_rest(); }

    void frame_shown(FrameReport frame)
    {
        playback_.frame_shown(frame);
        report::frame_shown(frame);
    }

    void fault(Error error)
    {
        playback_.fault();
        is_drawing_ = false;
        is_faulty_ = true;
        fault_light_.begin(now());
        report::fault(error);
    }

protected:
    void watch_arming() { playback_.watch_arming(control_pins_, now()); }
    const Computer& computer() const { return computer_; }
    const link::PlaybackSession& playback() const { return playback_; }
    bool is_drawing() const { return is_drawing_; }

private:
    const Clock& clock_;
    const Computer& computer_;
    link::PlaybackSession& playback_;
    ControlPins control_pins_;
    FaultLight fault_light_;
    bool is_drawing_ = false;
    bool is_faulty_ = false; ///< what was to be played cannot be
};

}
