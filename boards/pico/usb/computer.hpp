#pragma once

#include "boards/pico/chip/clock.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/link/playback_session.hpp"

namespace kfast::pico {

/// The computer at the other end of the USB cable, and the stage that it controls. There is one.
class Computer {
public:
    /// `clock` must outlive it.
    explicit Computer(const Clock& clock) : clock_{clock} {}

    /// Before anything else. What plays when the board starts is what its stage begins with. `display` has
    /// the facts about that and the settings; the computer knows the rest.
    void begin(const link::BoardFacts& display) const;
    /// The same, for a board that can show nothing.
    void begin_without_display() const;

    link::PlaybackSession& playback() const;

    /// Handles the reports that have come. The computer has to wait if this is not called for 16 ms.
    void serve() const;
    /// Sleeps, and handles reports as they come.
    void serve_until(Microseconds moment) const;
    /// The same, but returns as soon as the stage wants to begin something.
    void serve_until_change(Microseconds moment) const;

private:
    const Clock& clock_;
};

}
