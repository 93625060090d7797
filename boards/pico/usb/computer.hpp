#pragma once

#include "boards/pico/chip/clock.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/link/playback_session.hpp"

namespace kfast::pico {

/// Whoever is at the other end of the USB cable, and the stage that it speaks of. There is one.
class Computer {
public:
    /// `clock` must outlive it.
    explicit Computer(const Clock& clock) : clock_{clock} {}

    /// Before anything else. What plays when the board starts is what its stage begins with. `display` tells
    /// about that and the settings; of the rest the computer knows.
    void begin(const link::BoardFacts& display) const;
    /// Likewise, of a board that can show nothing.
    void begin_without_display() const;

    link::PlaybackSession& playback() const;

    /// Deals with the reports that have come. The computer has to wait if nobody does for 16 ms.
    void serve() const;
    /// Sleeps, and deals with reports as they come.
    void serve_until(Microseconds moment) const;
    /// Likewise, but returns as soon as the stage wants to begin something.
    void serve_until_change(Microseconds moment) const;

private:
    const Clock& clock_;
};

}
