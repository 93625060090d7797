#pragma once

#include "firmware/panel/oled_panel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Register values as found in drivers of 128x128 modules. What PanelSettings says is left to Ssd1351, and
/// switching on to OledPanel::light().
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
class Ssd1351 : public OledPanel<Bus, Controller::ssd1351, Arguments::as_parameters> {
    using Oled = OledPanel<Bus, Controller::ssd1351, Arguments::as_parameters>;

public:
    /// `bus` must outlive the panel.
    Ssd1351(Bus& bus, const PanelSettings& settings) : Oled{bus, settings} {}

    template <class Pause>
    void begin(Pause&& pause)
    {
        this->send_table(ssd1351_start_up, pause);
        // No more rows than the glass has, for the last one that is scanned is the uppermost of an upright
        // one.
        send(0xCA, scanned(settings_, memory).height - 1);
        send(0xA0, remap());
        send(settings_.inverted ? 0xA7 : 0xA6);
        set_brightness(settings_.brightness);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        // Columns and rows are the glass's own. Both are sent even if unchanged: 5C alone does not always
        // return to the beginning of the window.
        const bool across = lies_across(settings_.rotation);
        select(across ? 0x75 : 0x15, place_.column + area.x, area.width);
        select(across ? 0x15 : 0x75, place_.row + area.y, area.height);
        send(0x5C); // write
        start_colours(bus_, pixels);
    }

    void set_brightness(std::uint8_t brightness)
    {
        // The contrasts of the three colours, balanced for white.
        const auto dimmed = [brightness](int full) { return full * brightness / 255; };
        send(0xC1, dimmed(0xC8), dimmed(0x80), dimmed(0xC8));
    }

private:
    using Oled::bus_, Oled::memory, Oled::place_, Oled::send, Oled::select, Oled::settings_;

    int remap() const
    {
        constexpr int downwards = 0x01; // the next pixel is in the next row of the glass
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
};

template <>
struct PanelDriver<Controller::ssd1351> {
    template <DisplayBus Bus>
    using On = Ssd1351<Bus>;
};

}
