#pragma once

#include "firmware/panel/oled_panel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// As bright as drivers of 128x64 modules make them.
constexpr std::uint8_t ssd0323_contrast(std::uint8_t brightness)
{
    return static_cast<std::uint8_t>(brightness * 0x70 / 255);
}

/// Register values as found in drivers of 128x64 modules. Commands that only sibling controllers know (0x23,
/// 0xB0, 0xB4) are left out. The lowest row of the glass is wired to the first output. Switching on is left
/// to OledPanel::light().
constexpr auto ssd0323_start_up(const PanelSettings& settings)
{
    const Size memory = facts_of(Controller::ssd0323).memory;
    const bool upright = settings.rotation == Rotation::none;
    const auto last_row = static_cast<std::uint8_t>(scanned(settings, memory).height - 1);
    const int first_output = upright ? settings.glass.height % memory.height : settings.row;
    const auto offset = static_cast<std::uint8_t>(first_output);
    // The left pixel is in the high nibble: rotated by half, that of the byte at the other end.
    const std::uint8_t remap = upright ? 0x52 : 0x41;
    const std::uint8_t shown = settings.inverted ? 0xA7 : 0xA4;
    return std::to_array<StartUpStep>({
        {0xAE},                                             // display off
        {0xB3, 1, {0x91}},                                  // clock
        {0xA8, 1, {last_row}},                              // rows
        {0xA2, 1, {offset}},                                // display offset
        {0xA1, 1, {0x00}},                                  // start line
        {0xAD, 1, {0x02}},                                  // external supply
        {0xA0, 1, {remap}},                                 // nibbles, columns and rows from which end
        {0x86},                                             // full current
        {0x81, 1, {ssd0323_contrast(settings.brightness)}}, // contrast
        {0xB2, 1, {0x51}},                                  // row period
        {0xB1, 1, {0x55}},                                  // phase length
        {0xBC, 1, {0x10}},                                  // precharge voltage
        {0xBE, 1, {0x1C}},                                  // VCOMH
        {0xBF, 1, {0x0F}},                                  // VSL
        {0xB8, 8, {0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76}}, // grey table, evenly spaced
        {shown},                                                     // the memory, or its inverse
    });
}

/// Solomon SSD0323: OLED of up to 128 x 80 pixels, 16 greys, two pixels a byte.
template <DisplayBus Bus>
class Ssd0323 : public OledPanel<Bus, Controller::ssd0323, Arguments::with_command> {
    using Oled = OledPanel<Bus, Controller::ssd0323, Arguments::with_command>;

public:
    /// `bus` must outlive the panel. The picture is upright or rotated by half; the glass begins in an even
    /// column.
    Ssd0323(Bus& bus, const PanelSettings& settings) : Oled{bus, settings} {}

    template <class Pause>
    void begin(Pause&& pause)
    {
        this->send_table(ssd0323_start_up(settings_), pause);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        select(0x15, (place_.column + area.x) / 2, area.width / 2); // columns are counted in bytes
        select(0x75, place_.row + area.y, area.height);
        bus_.start_data(pixels);
    }

    void set_brightness(std::uint8_t brightness) { send(0x81, ssd0323_contrast(brightness)); }

private:
    using Oled::bus_, Oled::memory, Oled::place_, Oled::send, Oled::select, Oled::settings_;
};

template <>
struct PanelDriver<Controller::ssd0323> {
    template <DisplayBus Bus>
    using On = Ssd0323<Bus>;
};

}
