#include "firmware/panel/dcs_panel.hpp"

#include "tests/bytes.hpp"
#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

namespace kfast::test {

static_assert(PoweredPanel<DcsPanel<RecordingBus>>);
static_assert(LightedPanel<DcsPanel<RecordingBus>>);
static_assert(PoweredPanel<DcsPanel<RecordingWordBus>>);
static_assert(DcsPanel<RecordingBus>::format == PixelFormat::rgb565_be);
static_assert(DcsPanel<RecordingWordBus>::format == PixelFormat::rgb565);

namespace {

using Lines = std::vector<std::string>;

constexpr std::array brief_start_up{StartUpStep{.command = 0x01, .wait = {120'000}},
                                    StartUpStep{0x3A, 1, {0x55}}};
constexpr DcsController dimming{.memory = {240, 320}, .start_up = brief_start_up, .dims = true};
constexpr DcsController not_dimming{.memory = {240, 320}, .start_up = brief_start_up, .dims = false};

Lines begun(const PanelSettings& settings, const DcsController& controller = not_dimming)
{
    RecordingBus bus;
    DcsPanel{bus, settings, controller}.begin(bus.pause());
    return bus.lines;
}

/// The commands that open the window.
Lines window(const PanelSettings& settings, Rect area)
{
    RecordingBus bus;
    DcsController controller = not_dimming;
    controller.memory = facts_of(settings.controller).memory;
    DcsPanel{bus, settings, controller}.start(area, {});
    CHECK(bus.lines.back() == "pixels");
    bus.lines.pop_back();
    return bus.lines;
}

/// The window of the whole picture, turned.
Lines whole(PanelSettings settings, Rotation rotation)
{
    settings.rotation = rotation;
    const Size size = settings.size();
    return window(settings, {0, 0, size.width, size.height});
}

}

TEST_CASE("MIPI DCS: the start-up table, then what the settings say; it stays dark")
{
    CHECK(begun({.glass = {240, 240}}) == Lines{
                                              "pause 120000",
                                              "command 01",
                                              "pause 120000",
                                              "command 3A | 55",
                                              "command 36 | 00",
                                              "command 20",
                                          });
    CHECK(begun({.glass = {240, 240},
                 .rotation = Rotation::half,
                 .bgr = true,
                 .inverted = true,
                 .tearing_effect = true,
                 .brightness = 0x80},
                dimming) == Lines{
                                "pause 120000",
                                "command 01",
                                "pause 120000",
                                "command 3A | 55",
                                "command 36 | C8",
                                "command 21",
                                "command 35 | 00",
                                "command 53 | 24",
                                "command 51 | 80",
                            });
}

TEST_CASE("MIPI DCS: rotation and order of colours are bits of MADCTL")
{
    const auto mode = [](Rotation rotation, bool bgr) {
        return begun({.glass = {240, 320}, .rotation = rotation, .bgr = bgr})[4];
    };
    CHECK(mode(Rotation::none, false) == "command 36 | 00");
    CHECK(mode(Rotation::quarter, false) == "command 36 | 60");
    CHECK(mode(Rotation::half, false) == "command 36 | C0");
    CHECK(mode(Rotation::three_quarters, false) == "command 36 | A0");
    CHECK(mode(Rotation::none, true) == "command 36 | 08");
    CHECK(mode(Rotation::quarter, true) == "command 36 | 68");
    CHECK(mode(Rotation::half, true) == "command 36 | C8");
    CHECK(mode(Rotation::three_quarters, true) == "command 36 | A8");
}

TEST_CASE("MIPI DCS: a window is two words each of columns and rows, then the command to write")
{
    CHECK(window({.controller = Controller::ili9341, .glass = {240, 320}}, {16, 257, 3, 40}) ==
          Lines{"command 2A | 00 10 00 12", "command 2B | 01 01 01 28", "command 2C"});
}

TEST_CASE("MIPI DCS: a glass of 240x240 on an ST7789, in all rotations")
{
    const PanelSettings settings{.controller = Controller::st7789, .glass = {240, 240}};
    const std::string near = " | 00 00 00 EF";
    const std::string far = " | 00 50 01 3F"; // 80 to 319
    CHECK(whole(settings, Rotation::none) == Lines{"command 2A" + near, "command 2B" + near, "command 2C"});
    CHECK(whole(settings, Rotation::quarter) ==
          Lines{"command 2A" + near, "command 2B" + near, "command 2C"});
    CHECK(whole(settings, Rotation::half) == Lines{"command 2A" + near, "command 2B" + far, "command 2C"});
    CHECK(whole(settings, Rotation::three_quarters) ==
          Lines{"command 2A" + far, "command 2B" + near, "command 2C"});
}

TEST_CASE("MIPI DCS: a glass of 135x240 on an ST7789, in all rotations")
{
    const PanelSettings settings{
        .controller = Controller::st7789, .glass = {135, 240}, .column = 52, .row = 40};
    const std::string long_side = " | 00 28 01 17"; // 40 to 279
    CHECK(whole(settings, Rotation::none) ==
          Lines{"command 2A | 00 34 00 BA", "command 2B" + long_side, "command 2C"});
    CHECK(whole(settings, Rotation::quarter) ==
          Lines{"command 2A" + long_side, "command 2B | 00 35 00 BB", "command 2C"});
    CHECK(whole(settings, Rotation::half) ==
          Lines{"command 2A | 00 35 00 BB", "command 2B" + long_side, "command 2C"});
    CHECK(whole(settings, Rotation::three_quarters) ==
          Lines{"command 2A" + long_side, "command 2B | 00 34 00 BA", "command 2C"});
}

TEST_CASE("MIPI DCS: the memory is that of the controller which the settings name")
{
    const PanelSettings settings{
        .controller = Controller::st7735, .glass = {128, 128}, .column = 2, .row = 3};
    CHECK(whole(settings, Rotation::half) ==
          Lines{"command 2A | 00 02 00 81", "command 2B | 00 1F 00 9E", "command 2C"});
}

TEST_CASE("MIPI DCS: the picture of a glass that is turned by a quarter lies across it")
{
    RecordingBus bus;
    CHECK(DcsPanel{bus, {.glass = {135, 240}, .rotation = Rotation::quarter}, dimming}.size() ==
          Size{240, 135});
    CHECK(DcsPanel{bus, {.glass = {135, 240}, .rotation = Rotation::half}, dimming}.size() == Size{135, 240});
}

TEST_CASE("MIPI DCS: pixels go as words if the bus has any, as bytes otherwise")
{
    const auto pixels = bytes({0x12, 0x34, 0x56, 0x78});
    RecordingBus byte_bus;
    DcsPanel{byte_bus, {}, dimming}.start({0, 0, 2, 1}, pixels);
    CHECK(byte_bus.lines.back() == "pixels 12 34 56 78");
    RecordingWordBus word_bus;
    DcsPanel{word_bus, {}, dimming}.start({0, 0, 2, 1}, pixels);
    CHECK(word_bus.lines.back() == "words 12 34 56 78");
    CHECK(word_bus.lines.size() == 4);
}

TEST_CASE("MIPI DCS: sleep is dark first and lets the voltages settle; waking does, too, and stays dark")
{
    RecordingBus bus;
    DcsPanel panel{bus, {}, dimming};
    panel.sleep(bus.pause());
    CHECK(bus.lines == Lines{"command 28", "command 10", "pause 120000"});
    bus.lines.clear();
    panel.wake(bus.pause());
    CHECK(bus.lines == Lines{"command 11", "pause 120000"});
    bus.lines.clear();
    panel.light();
    CHECK(bus.lines == Lines{"command 29"});
}

TEST_CASE("MIPI DCS: brightness is sent to controllers that dim, to others nothing")
{
    RecordingBus bus;
    DcsPanel{bus, {}, dimming}.set_brightness(200);
    CHECK(bus.lines == Lines{"command 51 | C8"});
    bus.lines.clear();
    DcsPanel{bus, {}, not_dimming}.set_brightness(200);
    CHECK(bus.lines.empty());
}

TEST_CASE("MIPI DCS: the panel is busy as long as the bus is")
{
    RecordingBus bus;
    DcsPanel panel{bus, {}, dimming};
    CHECK_FALSE(panel.busy());
    bus.is_busy = true;
    CHECK(panel.busy());
}

}
