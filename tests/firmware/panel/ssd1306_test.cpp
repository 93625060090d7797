#include "firmware/panel/ssd1306.hpp"

#include "tests/bytes.hpp"
#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace kfast::test {

static_assert(PoweredPanel<Ssd1306<RecordingBus>>);
static_assert(LightedPanel<Ssd1306<RecordingBus>>);

namespace {

using Lines = std::vector<std::string>;

constexpr PanelSettings default_value = facts_of(Controller::ssd1306).default_value;

Lines begun(const PanelSettings& settings)
{
    RecordingBus bus;
    Ssd1306{bus, settings}.begin(bus.pause());
    return bus.lines;
}

/// What of the start-up differs from that of the usual glass.
Lines difference(const PanelSettings& settings)
{
    const Lines was = begun(default_value);
    Lines is = begun(settings);
    std::erase_if(is, [&was](const auto& line) { return std::ranges::count(was, line) != 0; });
    return is;
}

Lines window(const PanelSettings& settings, Rect area)
{
    RecordingBus bus;
    Ssd1306{bus, settings}.start(area, {});
    return bus.lines;
}

}

TEST_CASE("SSD1306: the start-up of the usual glass, byte by byte, all of it with D/C low")
{
    CHECK(begun(default_value) == Lines{
                                      "pause 10000",
                                      "command AE",
                                      "command D5 80",
                                      "command D3 00",
                                      "command 40",
                                      "command 8D 14",
                                      "command 20 00",
                                      "command D9 F1",
                                      "command DB 40",
                                      "command 2E",
                                      "command A4",
                                      "command A8 3F",
                                      "command A1",
                                      "command C8",
                                      "command DA 12",
                                      "command A6",
                                      "command 81 FF",
                                  });
}

TEST_CASE("SSD1306: the settings in the start-up")
{
    const auto with = [](auto change) {
        PanelSettings settings = default_value;
        change(settings);
        return difference(settings);
    };
    CHECK(with([](auto& s) { s.rotation = Rotation::half; }) == Lines{"command A0", "command C0"});
    CHECK(with([](auto& s) { s.inverted = true; }) == Lines{"command A7"});
    CHECK(with([](auto& s) { s.brightness = 0xCF; }) == Lines{"command 81 CF"});
    CHECK(with([](auto& s) { s.glass = {128, 32}; }) == Lines{"command A8 1F", "command DA 02"});
    CHECK(with([](auto& s) { s.glass = {64, 32}; }) == Lines{"command A8 1F"});
    CHECK(with([](auto& s) { s.row = 16, s.glass = {72, 40}; }) == Lines{"command A8 37"});
}

TEST_CASE("SSD1306: a window is columns and pages, their arguments with D/C low")
{
    CHECK(window(default_value, {0, 0, 128, 64}) == Lines{"command 21 00 7F", "command 22 00 07", "pixels"});
    CHECK(window(default_value, {24, 40, 16, 8}) == Lines{"command 21 18 27", "command 22 05 05", "pixels"});
}

TEST_CASE("SSD1306: a glass beside the middle is counted from the other side when it is turned by half")
{
    PanelSettings settings{.controller = Controller::ssd1306, .glass = {72, 40}, .column = 30, .row = 8};
    CHECK(window(settings, {0, 0, 72, 40}) == Lines{"command 21 1E 65", "command 22 01 05", "pixels"});
    settings.rotation = Rotation::half;
    CHECK(window(settings, {0, 0, 72, 40}) == Lines{"command 21 1A 61", "command 22 00 04", "pixels"});
}

TEST_CASE("SSD1306: rows of pixels are sent as pages, from memory of the panel's own")
{
    RecordingBus bus;
    Ssd1306 panel{bus, default_value};
    // A staircase down to the right, and beside it a row on the floor.
    panel.start({8, 8, 16, 8},
                bytes({0x80, 0, 0x40, 0, 0x20, 0, 0x10, 0, 0x08, 0, 0x04, 0, 0x02, 0, 0x01, 0xFF}));
    CHECK(bus.lines == Lines{
                           "command 21 08 17",
                           "command 22 01 01",
                           "pixels 01 02 04 08 10 20 40 80 80 80 80 80 80 80 80 80",
                       });
}

TEST_CASE("SSD1306: the whole picture is a kilobyte, page by page")
{
    RecordingBus bus;
    Ssd1306 panel{bus, default_value};
    std::vector<std::byte> rows(1024);
    std::fill_n(rows.begin() + 63 * 16, 16, std::byte{0xFF}); // the lowest row
    panel.start({0, 0, 128, 64}, rows);
    std::string expected = "pixels";
    for (int i = 0; i < 1024; ++i)
        expected += i < 7 * 128 ? " 00" : " 80";
    CHECK(bus.lines.back() == expected);
}

TEST_CASE("SSD1306: it stays dark until it is lit")
{
    RecordingBus bus;
    Ssd1306{bus, default_value}.light();
    CHECK(bus.lines == Lines{"command AF"});
}

TEST_CASE("SSD1306: asleep the charge pump stands still as well")
{
    RecordingBus bus;
    Ssd1306 panel{bus, default_value};
    panel.set_brightness(7);
    panel.sleep(bus.pause());
    panel.wake(bus.pause());
    CHECK(bus.lines == Lines{"command 81 07", "command AE", "command 8D 10", "command 8D 14"});
}

}
