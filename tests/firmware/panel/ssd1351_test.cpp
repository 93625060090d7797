#include "firmware/panel/ssd1351.hpp"

#include "tests/bytes.hpp"
#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {

static_assert(PoweredPanel<Ssd1351<RecordingBus>>);
static_assert(LightedPanel<Ssd1351<RecordingBus>>);
static_assert(Ssd1351<RecordingBus>::format == PixelFormat::rgb565_be);
static_assert(Ssd1351<RecordingWordBus>::format == PixelFormat::rgb565);

namespace {

using Lines = std::vector<std::string>;

constexpr PanelSettings default_value = facts_of(Controller::ssd1351).default_value;

std::string remap(Rotation rotation, bool bgr)
{
    PanelSettings settings = default_value;
    settings.rotation = rotation;
    settings.bgr = bgr;
    RecordingBus bus;
    Ssd1351{bus, settings}.begin(bus.pause());
    return bus.lines[15];
}

/// The commands that open a window of four columns and two rows at (16, 8) of a glass of 128x96.
Lines window(Rotation rotation, int row)
{
    const PanelSettings settings{
        .controller = Controller::ssd1351, .glass = {128, 96}, .row = row, .rotation = rotation};
    RecordingBus bus;
    Ssd1351{bus, settings}.start({16, 8, 4, 2}, {});
    CHECK(bus.lines.back() == "pixels");
    bus.lines.pop_back();
    return bus.lines;
}

}

TEST_CASE("SSD1351: the start-up of the usual glass, byte by byte, arguments with D/C high")
{
    RecordingBus bus;
    Ssd1351{bus, default_value}.begin(bus.pause());
    CHECK(bus.lines == Lines{
                           "pause 10000",
                           "command FD | 12",
                           "command FD | B1",
                           "command AE",
                           "command B3 | F1",
                           "command A1 | 00",
                           "command A2 | 00",
                           "command B5 | 00",
                           "command AB | 01",
                           "command B1 | 32",
                           "command BE | 05",
                           "command C7 | 0F",
                           "command B4 | A0 B5 55",
                           "command B6 | 01",
                           "command CA | 7F",
                           "command A0 | 74",
                           "command A6",
                           "command C1 | C8 80 C8",
                       });
}

TEST_CASE("SSD1351: rotation and order of colours are bits of the remap")
{
    CHECK(remap(Rotation::none, false) == "command A0 | 74");
    CHECK(remap(Rotation::quarter, false) == "command A0 | 77");
    CHECK(remap(Rotation::half, false) == "command A0 | 66");
    CHECK(remap(Rotation::three_quarters, false) == "command A0 | 65");
    CHECK(remap(Rotation::none, true) == "command A0 | 70");
    CHECK(remap(Rotation::three_quarters, true) == "command A0 | 61");
}

TEST_CASE("SSD1351: an inverted glass is inverted again")
{
    PanelSettings settings = default_value;
    settings.inverted = true;
    RecordingBus bus;
    Ssd1351{bus, settings}.begin(bus.pause());
    CHECK(bus.lines[16] == "command A7");
}

TEST_CASE("SSD1351: rows below the glass are not scanned")
{
    PanelSettings settings = default_value;
    settings.glass = {128, 96};
    const auto rows = [&settings] {
        RecordingBus bus;
        Ssd1351{bus, settings}.begin(bus.pause());
        return bus.lines[14];
    };
    CHECK(rows() == "command CA | 5F");
    settings.row = 32;
    CHECK(rows() == "command CA | 7F");
}

TEST_CASE("SSD1351: columns and rows of a window are those of the glass, also if the picture lies across it")
{
    CHECK(window(Rotation::none, 32) == Lines{"command 15 | 10 13", "command 75 | 28 29", "command 5C"});
    CHECK(window(Rotation::quarter, 32) == Lines{"command 75 | 30 33", "command 15 | 08 09", "command 5C"});
    for (const int row : {0, 32}) {
        CHECK(window(Rotation::half, row) == Lines{"command 15 | 10 13", "command 75 | 08 09", "command 5C"});
        CHECK(window(Rotation::three_quarters, row) ==
              Lines{"command 75 | 10 13", "command 15 | 08 09", "command 5C"});
    }
    CHECK(window(Rotation::none, 0) == Lines{"command 15 | 10 13", "command 75 | 08 09", "command 5C"});
    CHECK(window(Rotation::quarter, 0) == Lines{"command 75 | 10 13", "command 15 | 08 09", "command 5C"});
}

TEST_CASE("SSD1351: the window is sent again even if it is the same")
{
    RecordingBus bus;
    Ssd1351 panel{bus, default_value};
    panel.start({0, 0, 128, 128}, {});
    panel.start({0, 0, 128, 128}, {});
    const Lines once{"command 15 | 00 7F", "command 75 | 00 7F", "command 5C", "pixels"};
    Lines twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    CHECK(bus.lines == twice);
}

TEST_CASE("SSD1351: pixels go as words if the bus has any, as bytes otherwise")
{
    const auto pixels = bytes({0x12, 0x34});
    RecordingBus byte_bus;
    Ssd1351{byte_bus, default_value}.start({0, 0, 1, 1}, pixels);
    CHECK(byte_bus.lines.back() == "pixels 12 34");
    RecordingWordBus word_bus;
    Ssd1351{word_bus, default_value}.start({0, 0, 1, 1}, pixels);
    CHECK(word_bus.lines.back() == "words 12 34");
}

TEST_CASE("SSD1351: brightness keeps white white; sleep is the display off, and waking leaves it off")
{
    RecordingBus bus;
    Ssd1351 panel{bus, default_value};
    panel.set_brightness(128);
    panel.set_brightness(0);
    panel.sleep(bus.pause());
    panel.wake(bus.pause());
    panel.light();
    CHECK(bus.lines == Lines{"command C1 | 64 40 64", "command C1 | 00 00 00", "command AE", "command AF"});
}

}
