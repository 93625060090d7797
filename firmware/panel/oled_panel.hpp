#pragma once

#include "firmware/panel/colour_bus.hpp"
#include "firmware/panel/panel.hpp"
#include "firmware/panel/panel_driver.hpp"
#include "firmware/panel/picture_place.hpp"
#include "firmware/panel/start_up.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <concepts>
#include <span>

namespace kfast {

/// The time that OLED controllers get before the first command: modules without a reset line reset themselves
/// at power-up.
inline constexpr Microseconds oled_power_rise{10'000};

/// What the drivers of Solomon's OLED controllers have in common. `arguments` says how the controller takes
/// the arguments of a command. A driver adds begin(), start() and set_brightness(), and where the controller
/// makes its own voltage, sleep() and wake().
template <DisplayBus Bus, Controller controller, Arguments arguments>
class OledPanel {
public:
    static constexpr PixelFormat format =
        facts_of(controller).format == PixelFormat::rgb565 ? colour_format<Bus> : facts_of(controller).format;
    static constexpr Size granularity = facts_of(controller).granularity;
    static constexpr int window_bytes = facts_of(controller).window_bytes;

    Size size() const { return settings_.size(); }

    bool busy() { return bus_.busy(); }

    void light() { send(0xAF); } // display on

    template <class Pause>
    void sleep(Pause&&)
    {
        send(0xAE); // display off
    }

    template <class Pause>
    void wake(Pause&&)
    {
    }

protected:
    static constexpr Size memory = facts_of(controller).memory;

    /// `bus` must outlive the panel.
    OledPanel(Bus& bus, const PanelSettings& settings)
        : bus_{bus}, settings_{settings}, place_{picture_place(settings, scanned(settings, memory))}
    {
    }

    /// Sends a command with its arguments, the low byte of each.
    void send(int command, std::integral auto... values)
    {
        send_command<arguments>(bus_, command, values...);
    }

    template <class Pause>
    void send_table(std::span<const StartUpStep> table, Pause& pause)
    {
        pause(oled_power_rise);
        send_start_up<arguments>(bus_, table, pause);
    }

    /// Sets the window along `axis`, columns or rows: `count` of them from `first` on.
    void select(int axis, int first, int count) { send(axis, first, first + count - 1); }

    Bus& bus_;
    PanelSettings settings_;
    PicturePlace place_;
};

}
