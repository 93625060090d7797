#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// As many zeros: what the values mean is unpublished or does not matter.
WiredModel& send_zeros(WiredModel& wired, int command, int count)
{
    wired.low({command});
    for (int i = 0; i < count; ++i)
        wired.high({0});
    return wired;
}

WiredModel& wake(WiredModel& wired) { return wired.low({0x11}).wait(120); }

WiredModel& reset_and_wake(WiredModel& wired) { return wake(wired.wait(10).low({0x01}).wait(150)); }

/// The pixel at the left upper corner, when a red one was sent there.
int red_on_glass(WiredModel& wired, const PanelSettings& settings)
{
    const auto range = [&wired](int command, int at) { wired.send(command, {0, at, 0, at}); };
    range(0x2A, settings.column);
    range(0x2B, settings.row);
    wired.send(0x2C, {0xF8, 0x00});
    CHECK(wired.error() == "none");
    return pixels_of<PixelFormat::rgb565>(wired.model->picture())[0];
}

}

// What is widely sent to the usual modules is right, and red is red on them.

TEST_CASE("a known start-up of the ST7789 is accepted")
{
    const PanelSettings& settings = facts_of(Controller::st7789).default_value;
    WiredModel wired{settings};
    reset_and_wake(wired).send(0x3A, {0x55}).send(0x36, {0x00}).send(0xB0, {0x00, 0xC0});
    wired.send(0xB2, {0x0C, 0x0C, 0x00, 0x33, 0x33}).send(0xB7, {0x35}).send(0xBB, {0x19}).send(0xC0, {0x2C});
    wired.send(0xC2, {0x01, 0xFF}).send(0xC3, {0x12}).send(0xC4, {0x20}).send(0xC6, {0x0F});
    wired.send(0xD0, {0xA4, 0xA1});
    send_zeros(send_zeros(wired, 0xE0, 14), 0xE1, 14).low({0x21, 0x13, 0x29});
    CHECK(red_on_glass(wired, settings) == 0xF800);
}

TEST_CASE("a known start-up of the ILI9341 is accepted")
{
    const PanelSettings& settings = facts_of(Controller::ili9341).default_value;
    WiredModel wired{settings};
    wired.wait(5).send(0xEF, {0x03, 0x80, 0x02}).send(0xCF, {0x00, 0xC1, 0x30});
    wired.send(0xED, {0x64, 0x03, 0x12, 0x81}).send(0xE8, {0x85, 0x00, 0x78});
    wired.send(0xCB, {0x39, 0x2C, 0x00, 0x34, 0x02}).send(0xF7, {0x20}).send(0xEA, {0x00, 0x00});
    wired.send(0xC0, {0x23}).send(0xC1, {0x10}).send(0xC5, {0x3E, 0x28}).send(0xC7, {0x86});
    wired.send(0x36, {0x48}).send(0x3A, {0x55}).send(0xB1, {0x00, 0x18}).send(0xB6, {0x08, 0x82, 0x27});
    wired.send(0xF2, {0x00}).send(0x26, {0x01});
    wake(send_zeros(send_zeros(wired, 0xE0, 15), 0xE1, 15).wait(115)).low({0x29});
    CHECK(red_on_glass(wired, settings) == 0xF800);
}

TEST_CASE("a known start-up of the ST7735 is accepted")
{
    const PanelSettings& settings = facts_of(Controller::st7735).default_value;
    WiredModel wired{settings};
    reset_and_wake(wired.wait(110)).send(0xB1, {0x01, 0x2C, 0x2D}).send(0xB2, {0x01, 0x2C, 0x2D});
    wired.send(0xB3, {0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D}).send(0xB4, {0x07}).send(0xC0, {0xA2, 0x02, 0x84});
    wired.send(0xC1, {0xC5}).send(0xC2, {0x0A, 0x00}).send(0xC3, {0x8A, 0x2A}).send(0xC4, {0x8A, 0xEE});
    wired.send(0xC5, {0x0E}).low({0x20}).send(0x36, {0x08}).send(0x3A, {0x05});
    send_zeros(send_zeros(wired, 0xE0, 16), 0xE1, 16).low({0x13, 0x29});
    CHECK(red_on_glass(wired, settings) == 0xF800);
}

TEST_CASE("a known start-up of the GC9A01 is accepted")
{
    const PanelSettings& settings = facts_of(Controller::gc9a01).default_value;
    WiredModel wired{settings};
    wired.wait(5).low({0xEF}).send(0xEB, {0x14}).low({0xFE, 0xEF}).send(0xEB, {0x14}).send(0x84, {0x40});
    for (int command = 0x85; command <= 0x8F; ++command)
        wired.send(command, {0xFF});
    wired.send(0xB6, {0x00, 0x20}).send(0x36, {0x08}).send(0x3A, {0x05}).send(0x90, {8, 8, 8, 8});
    wired.send(0xBD, {0x06}).send(0xBC, {0x00}).send(0xFF, {0x60, 0x01, 0x04}).send(0xC3, {0x13});
    wired.send(0xC4, {0x13}).send(0xC9, {0x22}).send(0xBE, {0x11}).send(0xE1, {0x10, 0x0E});
    wired.send(0xDF, {0x21, 0x0C, 0x02});
    for (int command = 0xF0; command <= 0xF3; ++command)
        send_zeros(wired, command, 6);
    wired.send(0xED, {0x1B, 0x0B}).send(0xAE, {0x77}).send(0xCD, {0x63});
    send_zeros(wired, 0x70, 9).send(0xE8, {0x34});
    for (const int command : {0x62, 0x63})
        send_zeros(wired, command, 12);
    for (const int command : {0x66, 0x67})
        send_zeros(wired, command, 10);
    for (const int command : {0x64, 0x74})
        send_zeros(wired, command, 7);
    wake(wired.send(0x98, {0x3E, 0x07}).send(0x35, {0x00}).low({0x21}).wait(115)).low({0x29}).wait(20);
    CHECK(red_on_glass(wired, settings) == 0xF800);
}

TEST_CASE("a known start-up of the SSD1306 is accepted")
{
    WiredModel wired{facts_of(Controller::ssd1306).default_value};
    wired.low({0xAE, 0xD5, 0x80, 0xA8, 0x3F, 0xD3, 0x00, 0x40, 0x8D, 0x14, 0x20, 0x00, 0xA1,
               0xC8, 0xDA, 0x12, 0x81, 0xCF, 0xD9, 0xF1, 0xDB, 0x40, 0x2E, 0xA4, 0xA6, 0xAF});
    wired.low({0x21, 0, 127, 0x22, 0, 7}).high({0x01});
    CHECK(wired.error() == "none");
    CHECK(pixels_of<PixelFormat::mono1>(wired.model->picture())[0] == 1);
}

TEST_CASE("a known start-up of the SSD1351 is accepted")
{
    WiredModel wired{facts_of(Controller::ssd1351).default_value};
    wired.send(0xFD, {0x12}).send(0xFD, {0xB1}).low({0xAE}).send(0xB3, {0xF1}).send(0xCA, {0x7F});
    wired.send(0xA0, {0x74}).send(0xA1, {0x00}).send(0xA2, {0x00}).send(0xB5, {0x00}).send(0xAB, {0x01});
    wired.send(0xB1, {0x32}).send(0xBE, {0x05}).low({0xA6}).send(0xC1, {0xC8, 0x80, 0xC8}).send(0xC7, {0x0F});
    wired.send(0xB4, {0xA0, 0xB5, 0x55}).send(0xB6, {0x01}).low({0xAF});
    wired.send(0x15, {0, 127}).send(0x75, {0, 127}).send(0x5C, {0xF8, 0x00});
    CHECK(wired.error() == "none");
    CHECK(pixels_of<PixelFormat::rgb565>(wired.model->picture())[0] == 0xF800);
}

}
