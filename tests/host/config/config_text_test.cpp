#include "host/config/config_text.hpp"

#include "firmware/settings/board_record.hpp"
#include "firmware/settings/board_rules.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"
#include "tests/host/config/random_settings.hpp"

#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

std::optional<BoardSettings> read(const std::string& text)
{
    Diagnostics diagnostics;
    return config::read_config({"my.kdl", text}, diagnostics);
}

}

TEST_CASE("any settings that keep the rules come back from their text and from their record")
{
    std::mt19937 random{6};
    for (int i = 0; i < 3000; ++i) {
        const BoardSettings settings = random_settings(random);
        REQUIRE_FALSE(first_mistake(settings));
        const std::string text = config::config_text(settings);
        CAPTURE(text);
        REQUIRE(read(text) == settings);
        REQUIRE(read_board_record(board_record(*read(text))) == settings);
        REQUIRE(config::config_text(*read(text)) == text);
    }
}

TEST_CASE("settings with anything wrong come back from their text as they were, or not at all")
{
    std::mt19937 random{7};
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        BoardSettings settings = random_settings(random);
        settings.controls = {};
        if (!leads_beam(settings.bus)) {
            settings.panel.column += static_cast<int>(random() % 3) - 1;
            settings.panel.glass.height += static_cast<int>(random() % 3) - 1;
        }
        settings.bus_clock += static_cast<std::uint32_t>(random() % 5) * 20'000'000;
        settings.pins[random() % settings.pins.size()] = static_cast<Pin>(random());
        const auto again = read(config::config_text(settings));
        CAPTURE(config::config_text(settings));
        REQUIRE(again.has_value() == !first_mistake(settings));
        REQUIRE((!again || *again == settings));
        refused += !again;
    }
    CHECK(refused > 1000);
    CHECK(refused < 3000);
}

TEST_CASE("every brightness has a text of its own")
{
    BoardSettings settings = *read(std::string{config::configurations().front().text});
    for (int brightness = 0; brightness <= 255; ++brightness) {
        settings.panel.brightness = static_cast<std::uint8_t>(brightness);
        REQUIRE(read(config::config_text(settings)) == settings);
    }
    settings.panel.brightness = 204;
    CHECK(config::config_text(settings).find(" brightness=0.8\n") != std::string::npos);
}

TEST_CASE("the text has every field and tells what it means")
{
    const auto settings = read(R"(board pico {
        panel ssd1306 rotation=180 brightness=0.5
        bus i2c address=0x3D
        pins data=4 clock=5 log=0
        knob 26 place "wide awake"
        knob 27 input "left eye"
        clip idle
        button 12 pause
    })");
    REQUIRE(settings);
    CHECK(config::config_text(*settings) == R"(board pico {
    // The glass, not turned; the picture on it is 128 x 64
    panel ssd1306 128 64 column=0 row=0 rotation=180 colours=rgb inverted=#false brightness=0.5
    // The maker of ssd1306 allows (kHz)400
    bus i2c clock=(kHz)400 address=0x3D
    // Numbers of GPIOs; kfast wiring tells where they are
    pins clock=5 data=4 log=0
    // What plays when nothing is touched
    clip idle
    knob 26 place "wide awake"
    knob 27 input "left eye"
    button 12 pause
}
)");
}

TEST_CASE("the configurations of this program can be used as they are")
{
    CHECK(config::configurations().size() >= 6);
    for (const config::Configuration& configuration : config::configurations()) {
        CAPTURE(configuration.name);
        CHECK(configuration.text.starts_with("// "));
        const BoardSettings settings = config::chosen_settings(std::string{configuration.name});
        CHECK_FALSE(first_mistake(settings));
        CHECK(read(config::config_text(settings)) == settings);
    }
}

TEST_CASE("a sector holds the record and is erased behind it")
{
    std::mt19937 random{8};
    const BoardSettings settings = random_settings(random);
    const std::vector<std::byte> sector = config::settings_sector(settings);
    CHECK(sector.size() == 4096);
    CHECK(read_board_record(sector) == settings);
    CHECK(std::ranges::all_of(std::span{sector}.subspan(board_record_bytes),
                              [](std::byte byte) { return byte == std::byte{0xFF}; }));
}

}
