#pragma once

#include "firmware/panel/colour_bus.hpp"
#include "firmware/panel/panel.hpp"
#include "firmware/panel/panel_driver.hpp"
#include "firmware/panel/picture_place.hpp"
#include "firmware/panel/start_up.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// What differs between controllers that follow MIPI DCS.
struct DcsController {
    Size memory; ///< pixels that it stores
    /// Begins with SWRESET, for panels without a reset line, and leaves the controller awake and dark, with
    /// 16 bits a pixel. What PanelSettings says is left to DcsPanel.
    std::span<const StartUpStep> start_up;
    bool dims = false; ///< has an output for the backlight, dimmed by WRDISBV
};

/// A colour LCD whose controller follows MIPI DCS.
template <DisplayBus Bus>
class DcsPanel {
public:
    static constexpr PixelFormat format = colour_format<Bus>;
    static constexpr Size granularity{.width = 1, .height = 1};
    static constexpr int window_bytes = dcs_window_bytes;

    /// `bus` and `controller` must outlive the panel.
    DcsPanel(Bus& bus, const PanelSettings& settings, const DcsController& controller)
        : bus_{bus},
          settings_{settings},
          controller_{controller},
          place_{picture_place(settings, controller.memory)}
    {
    }

    Size size() const { return settings_.size(); }

    template <class Pause>
    void begin(Pause&& pause)
    {
        pause(settle); // the power, or the reset line, may have risen just now
        send_start_up<arguments>(bus_, controller_.start_up, pause);
        send_command<arguments>(bus_, 0x36, address_mode());             // MADCTL
        send_command<arguments>(bus_, settings_.inverted ? 0x21 : 0x20); // INVON, INVOFF
        if (settings_.tearing_effect)
            send_command<arguments>(bus_, 0x35, 0); // TEON: a pulse after every picture, none after its rows
        if (controller_.dims)
            send_command<arguments>(bus_, 0x53, 0x24); // WRCTRLD: brightness counts, backlight on
        set_brightness(settings_.brightness);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        select(0x2A, place_.column + area.x, area.width); // CASET
        select(0x2B, place_.row + area.y, area.height);   // RASET
        send_command<arguments>(bus_, 0x2C);              // RAMWR
        start_colours(bus_, pixels);
    }

    bool busy() { return bus_.busy(); }

    void light() { send_command<arguments>(bus_, 0x29); } // DISPON

    void set_brightness(std::uint8_t brightness)
    {
        if (controller_.dims)
            send_command<arguments>(bus_, 0x51, brightness); // WRDISBV
    }

    template <class Pause>
    void sleep(Pause&& pause)
    {
        send_command<arguments>(bus_, 0x28); // DISPOFF
        send_command<arguments>(bus_, 0x10); // SLPIN
        pause(settle);                       // before the power may go or SLPOUT may come
    }

    template <class Pause>
    void wake(Pause&& pause)
    {
        send_command<arguments>(bus_, 0x11); // SLPOUT
        pause(settle);
    }

private:
    static constexpr Arguments arguments = Arguments::as_parameters;
    static constexpr Microseconds settle{120'000}; // the ST7735 wants as much after a reset too, others 5 ms

    int address_mode() const
    {
        constexpr int rows_reversed = 0x80;    // MY
        constexpr int columns_reversed = 0x40; // MX
        constexpr int exchanged = 0x20;        // MV
        constexpr int bgr = 0x08;
        constexpr std::array turned{
            0,
            exchanged | columns_reversed,
            columns_reversed | rows_reversed,
            exchanged | rows_reversed,
        };
        return turned[static_cast<std::size_t>(settings_.rotation)] | (settings_.bgr ? bgr : 0);
    }

    void select(int axis, int first, int count)
    {
        const int last = first + count - 1;
        send_command<arguments>(bus_, axis, first >> 8, first, last >> 8, last);
    }

    Bus& bus_;
    PanelSettings settings_;
    const DcsController& controller_;
    PicturePlace place_;
};

/// The driver of a Controller that follows MIPI DCS.
template <const DcsController& controller>
struct DcsDriver {
    static constexpr const DcsController* dcs = &controller;

    template <DisplayBus Bus>
    using On = DcsPanel<Bus>;
};

}
