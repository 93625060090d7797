#pragma once

#include "boards/pico/board.hpp"
#include "boards/pico/clocks.hpp"
#include "boards/pico/computer.hpp"
#include "boards/pico/display_reset.hpp"
#include "boards/pico/fault_light.hpp"
#include "boards/pico/led.hpp"
#include "boards/pico/log.hpp"
#include "boards/pico/settings.hpp"
#include "boards/pico/usb_reports.hpp"
#include "firmware/panel_choice.hpp"
#include "firmware/run.hpp"

#include <optional>

namespace kfast::pico {

/// The life of a Pico whose display hangs on a `Bus` of the kind `bus_kind`: main() of an image.
template <class Bus, BusKind bus_kind>
class Gadget {
public:
    [[noreturn]] void live()
    {
        start_clocks();
        watchdog::start();
        led::begin();
        clock_.begin();
        usb_reports.begin();
        if (settings_) // else any pin may be wired to anything
            live_by(*settings_);
        computer_.begin_without_display();
        blink();
    }

private:
    void live_by(const BoardSettings& settings)
    {
        log.begin(settings.pin(PinRole::log));
        report::begun(settings.panel);
        if (accepts(settings))
            play(settings);
    }

    static bool accepts(const BoardSettings& settings)
    {
        const MaybeMistake mistake = first_mistake(settings);
        if (mistake)
            report::mistake(*mistake);
        else if (settings.bus != bus_kind)
            report::other_bus(settings.bus, bus_kind);
        return !mistake && settings.bus == bus_kind;
    }

    [[noreturn]] void play(const BoardSettings& settings)
    {
        computer_.begin(settings);
        Bus bus{settings};
        auto pause = [this](Microseconds time) { computer_.serve_until(clock_.now() + time); };
        reset_display(settings, pause);
        with_panel(bus, settings.panel, [this, &settings](auto& panel) {
            Board board{panel, settings, clock_, computer_};
            using B = decltype(board);
            static_assert(EventBoard<B> && ChoosingBoard<B> && InputBoard<B> && RestingBoard<B> &&
                          SynchronizedBoard<B> && NamedBoard<B> && ListeningBoard<B> && ChangingBoard<B> && ToldBoard<B>);
            run_stage(board);
        });
        __builtin_unreachable(); // the board wants to run for ever
    }

    /// What is left to do when nothing can be shown.
    [[noreturn]] void blink()
    {
        FaultLight light;
        light.begin(clock_.now());
        while (true) {
            computer_.serve_until(clock_.now() + FaultLight::half_a_second);
            light.pass(clock_.now());
        }
    }

    Clock clock_;
    Computer computer_{clock_};
    const std::optional<BoardSettings> settings_ = settings_for(bus_kind);
};

}
