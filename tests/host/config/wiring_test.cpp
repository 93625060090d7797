#include "host/config/wiring.hpp"

#include "firmware/settings/board_rules.hpp"
#include "host/config/config_input.hpp"
#include "host/config/pico_pins.hpp"
#include "tests/host/config/random_settings.hpp"

#include <doctest/doctest.h>
#include <map>
#include <random>

namespace kfast::test {
namespace {

/// part, end -> pin of the edge
std::map<std::pair<std::string, std::string>, int> pins_of(const BoardSettings& settings)
{
    std::map<std::pair<std::string, std::string>, int> pins;
    for (const config::Connection& wire : config::wiring(settings))
        CHECK(pins.emplace(std::pair{wire.part, wire.end}, wire.pin).second);
    return pins;
}

}

TEST_CASE("the edge of a Pico is as its maker's pinout has it")
{
    CHECK(config::edge_name(1) == "GP0");
    CHECK(config::edge_name(3) == "GND");
    CHECK(config::edge_name(20) == "GP15");
    CHECK(config::edge_name(21) == "GP16");
    CHECK(config::edge_name(29) == "GP22");
    CHECK(config::edge_name(30) == "RUN");
    CHECK(config::edge_name(31) == "GP26");
    CHECK(config::edge_name(33) == "AGND");
    CHECK(config::edge_name(34) == "GP28");
    CHECK(config::edge_name(36) == "3V3");
    CHECK(config::edge_name(40) == "VBUS");
    CHECK(config::edge_side(20) == "left");
    CHECK(config::edge_side(21) == "right");
    CHECK(config::nearest_ground(20) == 18);
    CHECK(config::nearest_ground(21) == 23);
    CHECK(config::nearest_ground(31) == 33);
}

TEST_CASE("a display by SPI has its wires, and what it is lit by")
{
    const auto pins = pins_of(config::chosen_settings("pico-st7789"));
    CHECK(pins.at({"display", "GND"}) == 38);
    CHECK(pins.at({"display", "VCC or 3V3"}) == 36);
    CHECK(pins.at({"display", "SCL, SCK or CLK"}) == 24);
    CHECK(pins.at({"display", "SDA, MOSI or DIN"}) == 25);
    CHECK(pins.at({"display", "RES or RST"}) == 26);
    CHECK(pins.at({"display", "DC, RS or A0"}) == 21);
    CHECK(pins.at({"display", "CS"}) == 22);
    CHECK(pins.at({"display", "BLK, BL or LED"}) == 27);
    CHECK(pins.size() == 8);
}

TEST_CASE("pins of the display that nobody drives are held")
{
    BoardSettings settings = config::chosen_settings("pico-st7789");
    for (const PinRole role : {PinRole::select, PinRole::reset, PinRole::backlight})
        settings.pin(role) = no_pin;
    const auto pins = pins_of(settings);
    CHECK(pins.at({"display", "CS"}) == 38);
    CHECK(pins.at({"display", "RES or RST"}) == 36);
    CHECK(pins.at({"display", "BLK, BL or LED"}) == 36);
}

TEST_CASE("an OLED has names of its own, and no backlight")
{
    const auto spi = pins_of(config::chosen_settings("pico-ssd1306"));
    CHECK(spi.at({"display", "D0, CLK or SCK"}) == 24);
    CHECK(spi.at({"display", "D1, DIN or MOSI"}) == 25);
    CHECK(spi.size() == 7);
    const auto i2c = pins_of(config::chosen_settings("pico-ssd1306-i2c"));
    CHECK(i2c.at({"display", "SCL or SCK"}) == 7);
    CHECK(i2c.at({"display", "SDA"}) == 6);
}

TEST_CASE("a parallel bus has eight wires for data, and does not read")
{
    const auto pins = pins_of(config::chosen_settings("pico-ili9341-parallel"));
    CHECK(pins.at({"display", "D0"}) == 1);
    CHECK(pins.at({"display", "D7"}) == 10);
    CHECK(pins.at({"display", "WR"}) == 11);
    CHECK(pins.at({"display", "RS or DC"}) == 12);
    CHECK(pins.at({"display", "RD"}) == 36);
}

TEST_CASE("a beam has its converters, and the wire that makes it dark")
{
    const auto pins = pins_of(config::chosen_settings("pico-xy-galvo"));
    CHECK(pins.at({"MCP4922", "VSS (12)"}) == 38);
    CHECK(pins.at({"MCP4922", "VDD (1)"}) == 36);
    CHECK(pins.at({"MCP4922", "CS (3)"}) == 22);
    CHECK(pins.at({"MCP4922", "SCK (4)"}) == 24);
    CHECK(pins.at({"MCP4922", "SDI (5)"}) == 25);
    CHECK(pins.at({"MCP4922", "LDAC (8)"}) == 21);
    CHECK(pins.at({"MCP4922", "SHDN (9)"}) == 36);
    CHECK(pins.at({"MCP4922", "VREFA (13)"}) == 36);
    CHECK(pins.at({"MCP4922", "VREFB (11)"}) == 36);
    CHECK(pins.at({"display", "Z or BLANK"}) == 26);
    CHECK(pins.at({"display", "GND"}) == 28);
    CHECK(pins.at({"button 1", "one leg"}) == 16);
    CHECK(pins.size() == 13);
    const std::string drawing =
        config::pico_drawing(config::wiring(config::chosen_settings("pico-xy-scope")));
    CHECK(drawing.find(" 25 GP19      SDI\n") != std::string::npos);
    CHECK(drawing.find(" 26 GP20      Z\n") != std::string::npos);
}

TEST_CASE("controls and the log are wired to the nearest ground")
{
    BoardSettings settings = config::chosen_settings("pico-ssd1306");
    settings.controls[0] = {ControlKind::button, ControlAction::play, 12, {"blink"}};
    settings.controls[3] = {ControlKind::knob, ControlAction::place, 26, {}};
    settings.controls[5] = {ControlKind::button, ControlAction::input, 13, {"open"}};
    settings.pin(PinRole::log) = 0;
    const auto pins = pins_of(settings);
    CHECK(pins.at({"button 1", "one leg"}) == 16);
    CHECK(pins.at({"button 1", "other leg"}) == 18);
    CHECK(pins.at({"knob 4", "left end"}) == 33);
    CHECK(pins.at({"knob 4", "slider"}) == 31);
    CHECK(pins.at({"knob 4", "right end"}) == 36);
    CHECK(pins.at({"serial adapter", "RXD"}) == 1);
    CHECK(pins.at({"serial adapter", "GND"}) == 3);
    CHECK(config::wiring(settings)[7].purpose == "play blink");
    CHECK(config::wiring(settings)[12].purpose == "input open");
}

TEST_CASE("every pin of any settings has a wire, and a mark on the drawing")
{
    std::mt19937 random{9};
    for (int i = 0; i < 300; ++i) {
        const BoardSettings settings = random_settings(random);
        const std::vector<config::Connection> wires = config::wiring(settings);
        std::map<int, int> uses;
        for (const config::Connection& wire : wires) {
            CHECK_FALSE(wire.end.empty());
            if (wire.gpio) {
                ++uses[*wire.gpio];
                CHECK(config::edge_name(wire.pin) == "GP" + std::to_string(*wire.gpio));
            }
        }
        int pins = 0;
        for (std::size_t user = 0; user < PinUser::count; ++user)
            pins += kfast::pins_of(settings, PinUser::number(user)).count;
        CHECK(uses.size() == static_cast<std::size_t>(pins));
    }
}

TEST_CASE("the drawing has forty pins with what goes to them")
{
    const std::string drawing =
        config::pico_drawing(config::wiring(config::chosen_settings("pico-ssd1306-i2c")));
    CHECK(drawing.starts_with("             +--|USB|--+\n      GP0  1 |o       o| 40 VBUS\n"));
    CHECK(drawing.find("\nSDA   GP4  6 |o       o| 35 ADC_VREF\nSCL   GP5  7 |o       o| 34 GP28\n") !=
          std::string::npos);
    CHECK(drawing.find(" 36 3V3       VCC\n") != std::string::npos); // RES is not on all modules
    CHECK(std::ranges::count(drawing, '\n') == 22);
}

}
