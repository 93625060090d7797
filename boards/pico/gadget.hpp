#pragma once

#include "boards/pico/board.hpp"
#include "boards/pico/clocks.hpp"
#include "boards/pico/display_reset.hpp"
#include "boards/pico/led.hpp"
#include "boards/pico/log.hpp"
#include "boards/pico/settings.hpp"
#include "firmware/panel_choice.hpp"
#include "firmware/run.hpp"

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
        log.begin(settings_.pin(PinRole::log));
        report::begun(settings_.panel);
        if (accepts_settings())
            show_scene();
        blink();
    }

private:
    bool accepts_settings() const
    {
        const MaybeMistake mistake = first_mistake(settings_);
        if (mistake)
            report::mistake(*mistake);
        else if (settings_.bus != bus_kind)
            report::other_bus(settings_.bus, bus_kind);
        return !mistake && settings_.bus == bus_kind;
    }

    void show_scene() const
    {
        Bus bus{settings_};
        auto pause = [this](Microseconds time) { clock_.sleep_until(clock_.now() + time); };
        reset_display(settings_, pause);
        with_panel(bus, settings_.panel, [this](auto& panel) {
            Board board{panel, settings_, clock_};
            using B = decltype(board);
            static_assert(EventBoard<B> && ChoosingBoard<B> && RestingBoard<B> && SynchronizedBoard<B> &&
                          NamedBoard<B>);
            while (board.wants_to_run())
                run(board);
        });
    }

    /// What is left to do when nothing can be shown.
    [[noreturn]] void blink() const
    {
        constexpr Microseconds half_a_second{500'000};
        while (true) {
            led::toggle();
            clock_.sleep_until(clock_.now() + half_a_second);
        }
    }

    Clock clock_;
    const BoardSettings settings_ = settings_for(bus_kind);
};

}
