#pragma once

#include "firmware/settings/board_rules.hpp"

/// The settings of a board whose flash holds none: for those who would rather change a line and compile than
/// store them with `kfast config`. What breaks a rule does not compile.
namespace kfast::pico {

/// A module with an ST7789 and 240 x 240 pixels.
inline constexpr BoardSettings spi_settings = [] {
    BoardSettings settings;
    settings.panel = facts_of(Controller::st7789).default_value;
    settings.bus = BusKind::spi;
    settings.bus_clock = 62'500'000;
    settings.pin(PinRole::clock) = 18;
    settings.pin(PinRole::data) = 19;
    settings.pin(PinRole::select) = 17;
    settings.pin(PinRole::dc) = 16;
    settings.pin(PinRole::reset) = 20;
    settings.pin(PinRole::backlight) = 21;
    return settings;
}();

/// A module with an SSD1306 and 128 x 64 pixels.
inline constexpr BoardSettings i2c_settings = [] {
    BoardSettings settings;
    settings.panel = facts_of(Controller::ssd1306).default_value;
    settings.bus = BusKind::i2c;
    settings.bus_clock = 400'000;
    settings.i2c_address = 0x3C;
    settings.pin(PinRole::clock) = 5;
    settings.pin(PinRole::data) = 4;
    return settings;
}();

/// A module with an ILI9341, 320 x 240 pixels in landscape.
inline constexpr BoardSettings parallel_settings = [] {
    BoardSettings settings;
    settings.panel = facts_of(Controller::ili9341).default_value;
    settings.panel.rotation = Rotation::quarter;
    settings.bus = BusKind::parallel_8;
    settings.bus_clock = 15'000'000;
    settings.pin(PinRole::clock) = 8;
    settings.pin(PinRole::data) = 0;
    settings.pin(PinRole::select) = 10;
    settings.pin(PinRole::dc) = 9;
    settings.pin(PinRole::reset) = 11;
    settings.pin(PinRole::backlight) = 12;
    return settings;
}();

/// An oscilloscope with an MCP4922 at x and y. It has no Z levels: what is dark is drawn fast.
inline constexpr BoardSettings dac_settings = [] {
    BoardSettings settings;
    settings.beam = scope_profile;
    settings.beam.brightness = BeamBrightness::by_speed;
    settings.bus = BusKind::dac;
    settings.bus_clock = 20'000'000;
    settings.pin(PinRole::clock) = 18;
    settings.pin(PinRole::data) = 19;
    settings.pin(PinRole::select) = 17;
    settings.pin(PinRole::ldac) = 16;
    settings.pin(PinRole::blank) = 20;
    return settings;
}();

static_assert(right_settings<spi_settings>().bus == BusKind::spi);
static_assert(right_settings<i2c_settings>().bus == BusKind::i2c);
static_assert(right_settings<parallel_settings>().bus == BusKind::parallel_8);
static_assert(right_settings<dac_settings>().bus == BusKind::dac);

constexpr const BoardSettings& default_settings(BusKind bus)
{
    switch (bus) {
    case BusKind::spi:
        break;
    case BusKind::i2c:
        return i2c_settings;
    case BusKind::parallel_8:
        return parallel_settings;
    case BusKind::dac:
        return dac_settings;
    }
    return spi_settings;
}

}
