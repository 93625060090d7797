#pragma once

#include "firmware/panel/oled_panel.hpp"
#include "firmware/panel/pages.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// How the rows of a glass are wired to the outputs of an SSD1306: long and low ones in sequence, others
/// alternately odd and even.
constexpr std::uint8_t ssd1306_row_wiring(Size glass)
{
    return glass.width > 64 && glass.height <= 32 ? 0x02 : 0x12;
}

/// Register values as found in drivers of 128x64 modules. What PanelSettings says is left to Ssd1306, and
/// switching on to OledPanel::light().
inline constexpr auto ssd1306_start_up = std::to_array<StartUpStep>({
    {0xAE},            // display off
    {0xD5, 1, {0x80}}, // clock
    {0xD3, 1, {0x00}}, // display offset
    {0x40},            // start line
    {0x8D, 1, {0x14}}, // charge pump on
    {0x20, 1, {0x00}}, // addresses count along the page, then to the next
    {0xD9, 1, {0xF1}}, // precharge
    {0xDB, 1, {0x40}}, // VCOMH
    {0x2E},            // no scrolling
    {0xA4},            // show the memory
});

/// Solomon SSD1306: OLED of up to 128 x 64 pixels, lit or dark, eight of them below each other in a byte.
/// Over SPI or I²C.
template <DisplayBus Bus>
class Ssd1306 : public OledPanel<Bus, Controller::ssd1306, Arguments::with_command> {
    using Oled = OledPanel<Bus, Controller::ssd1306, Arguments::with_command>;

public:
    /// `bus` must outlive the panel. The picture is upright or rotated by half; the glass begins in a row
    /// that is a multiple of 8.
    Ssd1306(Bus& bus, const PanelSettings& settings) : Oled{bus, settings} {}

    template <class Pause>
    void begin(Pause&& pause)
    {
        this->send_table(ssd1306_start_up, pause);
        send_glass();
        send(settings_.inverted ? 0xA7 : 0xA6);
        set_brightness(settings_.brightness);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        select(0x21, place_.column + area.x, area.width);
        select(0x22, (place_.row + area.y) / 8, area.height / 8);
        const std::span sent = std::span{pages_}.first(pixels.size());
        fill_pages(pixels, row_bytes(Oled::format, area.width), sent);
        bus_.start_data(sent);
    }

    void set_brightness(std::uint8_t brightness) { send(0x81, brightness); }

    template <class Pause>
    void sleep(Pause&&)
    {
        send(0xAE);
        send(0x8D, 0x10); // charge pump off
    }

    template <class Pause>
    void wake(Pause&&)
    {
        send(0x8D, 0x14);
    }

private:
    using Oled::bus_, Oled::memory, Oled::place_, Oled::send, Oled::select, Oled::settings_;

    void send_glass()
    {
        // An upright glass is wired from the last column and row to the first.
        const bool upright = settings_.rotation == Rotation::none;
        send(0xA8, scanned(settings_, memory).height - 1);
        send(upright ? 0xA1 : 0xA0);
        send(upright ? 0xC8 : 0xC0);
        send(0xDA, ssd1306_row_wiring(settings_.glass));
    }

    std::array<std::byte, row_bytes(Oled::format, memory.width) * memory.height> pages_{}; ///< being sent
};

template <>
struct PanelDriver<Controller::ssd1306> {
    template <DisplayBus Bus>
    using On = Ssd1306<Bus>;
};

}
