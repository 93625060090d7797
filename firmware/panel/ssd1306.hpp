#pragma once

#include "firmware/panel/oled_power.hpp"
#include "firmware/panel/pages.hpp"
#include "firmware/panel/panel.hpp"
#include "firmware/panel/picture_place.hpp"
#include "firmware/panel/start_up.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// How the rows of a glass are wired to the outputs of an SSD1306: long and low ones in sequence, others odd
/// and even by turns.
constexpr std::uint8_t ssd1306_row_wiring(Size glass)
{
    return glass.width > 64 && glass.height <= 32 ? 0x02 : 0x12;
}

/// Register values as found in drivers of 128x64 modules. What PanelSettings says, and to switch on, is left
/// to Ssd1306.
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
class Ssd1306 {
public:
    static constexpr PixelFormat format = facts_of(Controller::ssd1306).format;
    static constexpr Size granularity = facts_of(Controller::ssd1306).granularity;
    static constexpr int window_bytes = facts_of(Controller::ssd1306).window_bytes;

    /// `bus` must outlive the panel. The picture is upright or turned by half; the glass begins in a row that
    /// is a multiple of 8.
    Ssd1306(Bus& bus, const PanelSettings& settings)
        : bus_{bus}, settings_{settings}, place_{picture_place(settings, scanned(settings, memory))}
    {
    }

    Size size() const { return settings_.size(); }

    template <class Pause>
    void begin(Pause&& pause)
    {
        pause(oled_power_rise);
        send_start_up<arguments>(bus_, ssd1306_start_up, pause);
        send_glass();
        send_command<arguments>(bus_, settings_.inverted ? 0xA7 : 0xA6);
        set_brightness(settings_.brightness);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        select(0x21, place_.column + area.x, area.width);
        select(0x22, (place_.row + area.y) / 8, area.height / 8);
        const std::span sent = std::span{pages_}.first(pixels.size());
        fill_pages(pixels, row_bytes(format, area.width), sent);
        bus_.start_data(sent);
    }

    bool busy() { return bus_.busy(); }

    void light() { send_command<arguments>(bus_, 0xAF); } // display on

    void set_brightness(std::uint8_t brightness) { send_command<arguments>(bus_, 0x81, brightness); }

    template <class Pause>
    void sleep(Pause&&)
    {
        send_command<arguments>(bus_, 0xAE);
        send_command<arguments>(bus_, 0x8D, 0x10); // charge pump off
    }

    template <class Pause>
    void wake(Pause&&)
    {
        send_command<arguments>(bus_, 0x8D, 0x14);
    }

private:
    static constexpr Arguments arguments = Arguments::with_command;
    static constexpr Size memory = facts_of(Controller::ssd1306).memory;

    void send_glass()
    {
        // An upright glass is wired from the last column and row to the first.
        const bool upright = settings_.rotation == Rotation::none;
        send_command<arguments>(bus_, 0xA8, scanned(settings_, memory).height - 1);
        send_command<arguments>(bus_, upright ? 0xA1 : 0xA0);
        send_command<arguments>(bus_, upright ? 0xC8 : 0xC0);
        send_command<arguments>(bus_, 0xDA, ssd1306_row_wiring(settings_.glass));
    }

    void select(int axis, int first, int count)
    {
        send_command<arguments>(bus_, axis, first, first + count - 1);
    }

    Bus& bus_;
    PanelSettings settings_;
    PicturePlace place_;
    std::array<std::byte, row_bytes(format, memory.width) * memory.height> pages_{}; ///< on their way
};

}
