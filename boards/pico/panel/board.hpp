#pragma once

#include "boards/pico/app/playback_board.hpp"
#include "boards/pico/chip/memory.hpp"
#include "boards/pico/panel/dimmer.hpp"
#include "boards/pico/panel/tearing_line.hpp"
#include "firmware/link/restart_notice.hpp"
#include "firmware/run/tearing_wait.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A Pico with a panel. The backlight is dark until a picture has arrived, and while the display rests.
template <class Display>
class Board : public PlaybackBoard {
public:
    /// All of them must outlive the board. The computer has begun.
    Board(Display& panel, const BoardSettings& settings, const Clock& clock, const Computer& computer)
        : PlaybackBoard{settings, clock, computer},
          panel_{panel},
          settings_{settings},
          light_{settings.pin(PinRole::backlight)},
          tearing_line_{settings.pin(PinRole::tearing)}
    {
    }

    BoardNames names() const { return {"Pico", controller_name(settings_.panel.controller)}; }

    Notice notice() const { return notice_.notice(); }
    void notice_shown() { light_.set(brightness_); }

    Display& panel() { return panel_; }
    std::array<std::span<std::byte>, 2> bands() { return memory::bands(); }

    bool running()
    {
        if (!is_drawing())
            stand_by();
        return PlaybackBoard::running();
    }

    void steer(Playhead& playhead)
    {
        PlaybackBoard::steer(playhead);
        if (playback().wants_rest())
            light_.set(0);
        else if (playback().brightness() != brightness_)
            set_brightness(playback().brightness());
    }

    void wait_for_blank()
    {
        if (settings_.panel.tearing_effect)
            tearing_wait_.wait([this] { return tearing_line_.pictures(); },
                               [this] {
                                   computer().serve();
                                   return now();
                               });
    }

    void frame_shown(FrameReport frame)
    {
        light_.set(brightness_); // not before: until now the display showed whatever it woke up with
        PlaybackBoard::frame_shown(frame);
    }

    void fault(Error error)
    {
        light_.set(brightness_);
        PlaybackBoard::fault(error);
    }

private:
    /// To be called while no frames are drawn.
    void stand_by()
    {
        if (playback().brightness() == brightness_)
            return;
        set_brightness(playback().brightness());
        light_.set(brightness_);
    }

    void set_brightness(std::uint8_t brightness)
    {
        brightness_ = brightness;
        panel_.set_brightness(brightness);
    }

    Display& panel_;
    const BoardSettings& settings_;
    Dimmer light_;
    TearingLine tearing_line_;
    TearingWait tearing_wait_;
    link::RestartNotice notice_{playback().playing().restarts};
    std::uint8_t brightness_ = settings_.panel.brightness;
};

}
