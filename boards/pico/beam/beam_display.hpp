#pragma once

#include "boards/pico/app/settings.hpp"
#include "boards/pico/beam/beam_board.hpp"
#include "boards/pico/beam/shutter.hpp"
#include "firmware/run/run.hpp"

namespace kfast::pico {

/// A vector display, as an App's display.
struct BeamDisplay {
    /// Makes the beam dark: before anything else, and only on a pin that the settings can mean.
    static void make_safe(const BoardSettings& settings)
    {
        if (leads_beam(settings.bus) && !mistake_in(settings))
            shutter::begin(settings.pin(PinRole::blank));
    }

    static link::BoardFacts facts(const BoardSettings& settings)
    {
        const BeamProfile& beam = settings.beam;
        shutter::set_armed(!beam.is_laser);
        return {.settings = settings,
                .panel = {"beam"},
                .panel_size = {beam.resolution, beam.resolution},
                .player_bytes = link::beam_player_bytes,
                .set_armed = beam.is_laser ? shutter::set_armed : nullptr};
    }

    /// The computer has begun.
    [[noreturn]] static void play(const BoardSettings& settings, const Clock& clock, const Computer& computer)
    {
        DacBeam beam{settings};
        BeamBoard board{beam, settings, clock, computer};
        using B = BeamBoard;
        static_assert(EventBoard<B> && ChoosingBoard<B> && InputBoard<B> && RestingBoard<B> &&
                      ListeningBoard<B> && ChangingBoard<B> && LiveInputBoard<B>);
        run_scenes(board);
        __builtin_unreachable(); // the board runs for ever
    }
};

}
