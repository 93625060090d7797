#pragma once

#include "firmware/panel/colour_bus.hpp"
#include "firmware/panel/oled_power.hpp"
#include "firmware/panel/panel.hpp"
#include "firmware/panel/picture_place.hpp"
#include "firmware/panel/start_up.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Register values as found in drivers of 128x128 modules. What PanelSettings says, and to switch on, is left
/// to Ssd1351.
inline constexpr auto ssd1351_start_up = std::to_array<StartUpStep>({
    {0xFD, 1, {0x12}},             // unlock
    {0xFD, 1, {0xB1}},             // unlock what is set below
    {0xAE},                        // display off
    {0xB3, 1, {0xF1}},             // clock: the fastest
    {0xA1, 1, {0x00}},             // start line
    {0xA2, 1, {0x00}},             // display offset
    {0xB5, 1, {0x00}},             // GPIO off
    {0xAB, 1, {0x01}},             // own regulator, 8 bits of bus
    {0xB1, 1, {0x32}},             // phase length
    {0xBE, 1, {0x05}},             // VCOMH
    {0xC7, 1, {0x0F}},             // full current
    {0xB4, 3, {0xA0, 0xB5, 0x55}}, // segment low voltage
    {0xB6, 1, {0x01}},             // second precharge
});

/// Solomon SSD1351: OLED of up to 128 x 128 pixels, 16-bit colour.
template <DisplayBus Bus>
class Ssd1351 {
public:
    static constexpr PixelFormat format = colour_format<Bus>;
    static constexpr Size granularity = facts_of(Controller::ssd1351).granularity;
    static constexpr int window_bytes = facts_of(Controller::ssd1351).window_bytes;

    /// `bus` must outlive the panel.
    Ssd1351(Bus& bus, const PanelSettings& settings)
        : bus_{bus}, settings_{settings}, place_{picture_place(settings, scanned(settings, memory))}
    {
    }

    Size size() const { return settings_.size(); }

    template <class Pause>
    void begin(Pause&& pause)
    {
        pause(oled_power_rise);
        send_start_up<arguments>(bus_, ssd1351_start_up, pause);
        // No more rows than the glass has, for the last one that is scanned is the uppermost of an upright
        // one.
        send_command<arguments>(bus_, 0xCA, scanned(settings_, memory).height - 1);
        send_command<arguments>(bus_, 0xA0, remap());
        send_command<arguments>(bus_, settings_.inverted ? 0xA7 : 0xA6);
        set_brightness(settings_.brightness);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        // Columns and rows are the glass's own. Both are sent even if unchanged: 5C alone does not always go
        // back to where the window begins.
        const bool across = lies_across(settings_.rotation);
        select(across ? 0x75 : 0x15, place_.column + area.x, area.width);
        select(across ? 0x15 : 0x75, place_.row + area.y, area.height);
        send_command<arguments>(bus_, 0x5C); // write
        start_colours(bus_, pixels);
    }

    bool busy() { return bus_.busy(); }

    void light() { send_command<arguments>(bus_, 0xAF); } // display on

    void set_brightness(std::uint8_t brightness)
    {
        // The contrasts of the three colours, balanced for white.
        const auto dimmed = [brightness](int full) { return full * brightness / 255; };
        send_command<arguments>(bus_, 0xC1, dimmed(0xC8), dimmed(0x80), dimmed(0xC8));
    }

    template <class Pause>
    void sleep(Pause&&)
    {
        send_command<arguments>(bus_, 0xAE);
    }

    template <class Pause>
    void wake(Pause&&)
    {
    }

private:
    static constexpr Arguments arguments = Arguments::as_parameters;
    static constexpr Size memory = facts_of(Controller::ssd1351).memory;

    int remap() const
    {
        constexpr int downwards = 0x01; // the next pixel lies in the next row of the glass
        constexpr int columns_reversed = 0x02;
        constexpr int red_first = 0x04;
        constexpr int rows_reversed = 0x10; // an upright glass is wired from the last row to the first
        constexpr int rows_split = 0x20;    // odd and even rows come from different sides
        constexpr int colours_65k = 0x40;
        constexpr std::array turned{
            rows_reversed,
            downwards | columns_reversed | rows_reversed,
            columns_reversed,
            downwards,
        };
        const int glass = colours_65k | rows_split | (settings_.bgr ? 0 : red_first);
        return glass | turned[static_cast<std::size_t>(settings_.rotation)];
    }

    void select(int axis, int first, int count)
    {
        send_command<arguments>(bus_, axis, first, first + count - 1);
    }

    Bus& bus_;
    PanelSettings settings_;
    PicturePlace place_;
};

}
