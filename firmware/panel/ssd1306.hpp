#pragma once

#include "firmware/controller_facts.hpp"
#include "firmware/panel.hpp"
#include "firmware/panel/pages.hpp"
#include "firmware/panel/picture_place.hpp"
#include "firmware/start_up.hpp"

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

/// Register values as found in drivers of 128x64 and 128x32 modules. Only the rows of the glass are scanned,
/// in whichever direction.
constexpr auto ssd1306_start_up(const PanelSettings& settings)
{
    const bool upright = settings.rotation == Rotation::none;
    const auto rows = static_cast<std::uint8_t>(settings.glass.height - 1);
    const auto start_line = static_cast<std::uint8_t>(0x40 + settings.row);
    const std::uint8_t columns_from = upright ? 0xA1 : 0xA0; // glasses are wired from the last to the first
    const std::uint8_t rows_from = upright ? 0xC8 : 0xC0;
    const std::uint8_t lit = settings.inverted ? 0xA7 : 0xA6;
    return std::to_array<StartUpStep>({
        {0xAE},                                          // display off
        {0xD5, 1, {0x80}},                               // clock
        {0xA8, 1, {rows}},                               // rows
        {0xD3, 1, {0x00}},                               // display offset
        {start_line},                                    // display start line
        {0x8D, 1, {0x14}},                               // charge pump on
        {0x20, 1, {0x00}},                               // addresses count along the page, then to the next
        {columns_from},                                  // segment remap
        {rows_from},                                     // direction of the rows
        {0xDA, 1, {ssd1306_row_wiring(settings.glass)}}, // wiring of the rows
        {0x81, 1, {settings.brightness}},                // contrast
        {0xD9, 1, {0xF1}},                               // precharge
        {0xDB, 1, {0x40}},                               // VCOMH
        {0x2E},                                          // no scrolling
        {0xA4},                                          // show the memory
        {lit},                                           // set bits are lit, or clear ones
        {0xAF},                                          // display on
    });
}

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
        : bus_{bus}, settings_{settings}, column_{picture_place(settings, memory).column}
    {
    }

    Size size() const { return settings_.size(); }

    template <class Pause>
    void begin(Pause&& pause)
    {
        pause(Microseconds{10'000}); // modules without a reset line reset themselves when the power comes
        send_start_up<arguments>(bus_, ssd1306_start_up(settings_), pause);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        select(0x21, column_ + area.x, area.width);
        select(0x22, (settings_.row + area.y) / 8, area.height / 8);
        const std::span sent = std::span{pages_}.first(pixels.size());
        fill_pages(pixels, row_bytes(format, area.width), sent);
        bus_.start_data(sent);
    }

    bool busy() { return bus_.busy(); }

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
        send_command<arguments>(bus_, 0xAF);
    }

private:
    static constexpr Arguments arguments = Arguments::with_command;
    static constexpr Size memory = facts_of(Controller::ssd1306).memory;

    void select(int axis, int first, int count)
    {
        send_command<arguments>(bus_, axis, first, first + count - 1);
    }

    Bus& bus_;
    PanelSettings settings_;
    int column_; ///< of the picture's left edge
    std::array<std::byte, row_bytes(format, memory.width) * memory.height> pages_{}; ///< on their way
};

}
