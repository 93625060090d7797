#pragma once

#include "boards/pico/app/fault_light.hpp"
#include "boards/pico/app/log.hpp"
#include "boards/pico/app/report.hpp"
#include "boards/pico/app/settings.hpp"
#include "boards/pico/chip/clocks.hpp"
#include "boards/pico/chip/led.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "boards/pico/usb/computer.hpp"
#include "boards/pico/usb/usb_reports.hpp"

#include <optional>

namespace kfast::pico {

/// Runs a Pico whose display (panel_display.hpp, beam_display.hpp) is connected by wires of the kind
/// `bus_kind`: main() of an image.
template <class Display, BusKind bus_kind>
class App {
public:
    [[noreturn]] void run()
    {
        if (settings_)
            Display::make_safe(*settings_);
        start_clocks();
        watchdog::start();
        led::begin();
        clock_.begin();
        usb_reports.begin();
        if (settings_) // else any pin may be wired to anything
            run_with(*settings_);
        computer_.begin_without_display();
        blink();
    }

private:
    void run_with(const BoardSettings& settings)
    {
        log.begin(settings.pin(PinRole::log));
        report::begun(settings);
        if (!accepts(settings))
            return;
        computer_.begin(Display::facts(settings));
        report::restarted(computer_.playback().playing().restarts);
        Display::play(settings, clock_, computer_);
    }

    static bool accepts(const BoardSettings& settings)
    {
        const MaybeMistake mistake = mistake_in(settings);
        if (mistake)
            report::mistake(*mistake);
        else if (settings.bus != bus_kind)
            report::other_bus(settings.bus, bus_kind);
        return !mistake && settings.bus == bus_kind;
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
