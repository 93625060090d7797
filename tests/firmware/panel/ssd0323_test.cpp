#include "firmware/panel/ssd0323.hpp"

#include "tests/bytes.hpp"
#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {

static_assert(PoweredPanel<Ssd0323<RecordedBus>>);
static_assert(LightedPanel<Ssd0323<RecordedBus>>);

namespace {

constexpr PanelSettings default_value = facts_of(Controller::ssd0323).default_value;

}

TEST_CASE("SSD0323: the start-up sequence, byte by byte, all of it with D/C low")
{
    RecordedBus bus;
    Ssd0323 panel{bus, default_value};
    panel.begin([&bus](Microseconds time) {
        CHECK(bus.sent.empty());
        CHECK(time == Microseconds{10'000});
    });

    std::vector<std::byte> sent;
    for (const auto& transfer : bus.sent) {
        CHECK_FALSE(transfer.data);
        sent.insert(sent.end(), transfer.bytes.begin(), transfer.bytes.end());
    }
    CHECK(sent == bytes({0xAE, 0xB3, 0x91, 0xA8, 0x3F, 0xA2, 0x40, 0xA1, 0x00, 0xAD, 0x02, 0xA0,
                         0x52, 0x86, 0x81, 0x70, 0xB2, 0x51, 0xB1, 0x55, 0xBC, 0x10, 0xBE, 0x1C,
                         0xBF, 0x0F, 0xB8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, 0xA4}));
}

TEST_CASE("SSD0323: a window counts columns in bytes; its parameters go with D/C low, pixels with D/C high")
{
    RecordedBus bus;
    Ssd0323 panel{bus, default_value};
    const auto pixels = bytes({0x12, 0x34, 0x56, 0x78});
    panel.start({.x = 32, .y = 24, .width = 4, .height = 2}, pixels);
    CHECK(bus.sent == std::vector<RecordedBus::Transfer>{
                          {false, bytes({0x15, 16, 17})},
                          {false, bytes({0x75, 24, 25})},
                          {true, pixels},
                      });
}

TEST_CASE("SSD0323: the whole panel is columns 0 to 63 and rows 0 to 63")
{
    RecordedBus bus;
    Ssd0323 panel{bus, default_value};
    panel.start({.x = 0, .y = 0, .width = 128, .height = 64}, {});
    REQUIRE(bus.sent.size() == 3);
    CHECK(bus.sent[0].bytes == bytes({0x15, 0, 63}));
    CHECK(bus.sent[1].bytes == bytes({0x75, 0, 63}));
}

TEST_CASE("SSD0323: the panel is busy as long as the bus is")
{
    RecordedBus bus;
    Ssd0323 panel{bus, default_value};
    CHECK_FALSE(panel.busy());
    bus.is_busy = true;
    CHECK(panel.busy());
}

TEST_CASE("SSD0323: the settings in the start-up")
{
    PanelSettings settings = default_value;
    settings.rotation = Rotation::half;
    settings.inverted = true;
    settings.brightness = 128;
    settings.glass = {128, 56};
    settings.row = 3;
    RecordingBus bus;
    Ssd0323{bus, settings}.begin(bus.pause());
    CHECK(bus.lines[3] == "command A8 3A");
    CHECK(bus.lines[4] == "command A2 03");
    CHECK(bus.lines[7] == "command A0 41");
    CHECK(bus.lines[9] == "command 81 38");
    CHECK(bus.lines[16] == "command A7");
}

TEST_CASE("SSD0323: the output of the uppermost row is found by the height of an upright glass")
{
    const auto offset = [](int height) {
        RecordingBus bus;
        Ssd0323{bus, {.controller = Controller::ssd0323, .glass = {128, height}}}.begin(bus.pause());
        return bus.lines[4];
    };
    CHECK(offset(56) == "command A2 38");
    CHECK(offset(64) == "command A2 40");
    CHECK(offset(80) == "command A2 00"); // as far as 80 would be, and allowed
}

TEST_CASE("SSD0323: a glass beside the middle is counted from the other side when it is turned by half")
{
    PanelSettings settings{.controller = Controller::ssd0323, .glass = {96, 64}, .column = 20, .row = 8};
    const auto window = [&settings] {
        RecordingBus bus;
        Ssd0323{bus, settings}.start({0, 0, 96, 64}, {});
        return bus.lines;
    };
    CHECK(window() == std::vector<std::string>{"command 15 0A 39", "command 75 08 47", "pixels"});
    settings.rotation = Rotation::half;
    CHECK(window() == std::vector<std::string>{"command 15 06 35", "command 75 00 3F", "pixels"});
}

TEST_CASE("SSD0323: brightness and sleep; waking leaves it dark")
{
    RecordingBus bus;
    Ssd0323 panel{bus, default_value};
    panel.set_brightness(255);
    panel.set_brightness(0);
    panel.sleep(bus.pause());
    panel.wake(bus.pause());
    panel.light();
    CHECK(bus.lines ==
          std::vector<std::string>{"command 81 70", "command 81 00", "command AE", "command AF"});
}

}
