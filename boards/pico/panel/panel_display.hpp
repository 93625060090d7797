#pragma once

#include "boards/pico/panel/board.hpp"
#include "boards/pico/panel/display_reset.hpp"
#include "firmware/panel/panel_choice.hpp"
#include "firmware/run/run.hpp"

namespace kfast::pico {

/// A panel on a `Bus`, as an App's display.
template <class Bus>
struct PanelDisplay {
    static void make_safe(const BoardSettings&) {}

    static link::BoardFacts facts(const BoardSettings& settings)
    {
        return {.settings = settings,
                .panel = {controller_name(settings.panel.controller)},
                .panel_size = settings.panel.size(),
                .is_dimmable = true};
    }

    /// The computer has begun.
    [[noreturn]] static void play(const BoardSettings& settings, const Clock& clock, const Computer& computer)
    {
        Bus bus{settings};
        auto pause = [&](Microseconds time) { computer.serve_until(clock.now() + time); };
        reset_display(settings, pause);
        with_panel(bus, settings.panel, [&](auto& panel) {
            Board board{panel, settings, clock, computer};
            using B = decltype(board);
            static_assert(EventBoard<B> && ChoosingBoard<B> && InputBoard<B> && RestingBoard<B> &&
                          SynchronizedBoard<B> && NamedBoard<B> && NoticingBoard<B> && ListeningBoard<B> &&
                          ChangingBoard<B> && LiveInputBoard<B>);
            run_scenes(board);
        });
        __builtin_unreachable(); // the board runs for ever
    }
};

}
