#pragma once

#include "boards/pico/app/playback_board.hpp"
#include "boards/pico/beam/dac_beam.hpp"

namespace kfast::pico {

/// A Pico with a vector display.
class BeamBoard : public PlaybackBoard {
public:
    /// All of them must outlive the board. The computer has begun.
    BeamBoard(DacBeam& beam, const BoardSettings& settings, const Clock& clock, const Computer& computer)
        : PlaybackBoard{settings, clock, computer}, beam_{beam}
    {
    }

    DacBeam& beam() { return beam_; }

    // The button that disarms is polled wherever time passes, however slow or large the scene is.
    void listen()
    {
        watch_arming();
        PlaybackBoard::listen();
    }
    void linger_until(Microseconds moment)
    {
        constexpr Microseconds look{10'000};
        do {
            watch_arming();
            const Microseconds soon = now() + look;
            PlaybackBoard::linger_until(reached(soon, moment) ? moment : soon);
        } while (!playback().wants_to_begin() && !reached(now(), moment));
    }

private:
    DacBeam& beam_;
};

}
