#include "tests/host/simulator/wired_dcs.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("DCS models: brightness, tearing effect and vendors' commands have parameters that are counted")
{
    WiredModel wired{with_glass(Controller::st7789, {1, 1})};
    start(wired).send(0x51, {128}).send(0x35, {0}).low({0x34}).send(0xB2, {0x0C, 0x0C, 0, 0x33, 0x33});
    wired.send(0xC2, {1}).send(0xC2, {1, 255}).send(0x44, {0, 10});
    CHECK(wired.error() == "none");
    CHECK(wired.low({0x35}).low({0x34}).error() ==
          "byte 26 at 240.000 ms: command 0x34 where 0x35 lacks parameters");
}

TEST_CASE("DCS models: every mistake is named with the place of its byte and its time")
{
    StartedSt7735 wired; // 6 bytes, 240 ms
    const auto error = [&wired] { return wired.error(); };
    const auto at = [](int byte, const std::string& what) {
        return "byte " + std::to_string(byte) + " at 240.000 ms: " + what;
    };
    SUBCASE("unknown command")
    {
        wired.low({0x00, 0x3C});
        CHECK(error() == at(7, "unknown command 0x3C"));
    }
    SUBCASE("what no model knows")
    {
        wired.low({0x12});
        CHECK(error() == at(6, "command 0x12 is not modelled"));
    }
    SUBCASE("parameters missing")
    {
        wired.send(0x2A, {0, 2, 0}).low({0x2B});
        CHECK(error() == at(10, "command 0x2B where 0x2A lacks parameters"));
    }
    SUBCASE("parameters of a vendor's command missing")
    {
        wired.send(0xB1, {1, 0x2C}).low({0x00});
        CHECK(error() == at(9, "command 0x00 where 0xB1 lacks parameters"));
    }
    SUBCASE("too many parameters")
    {
        wired.send(0x36, {0, 0});
        CHECK(error() == at(8, "more parameters than 0x36 has"));
    }
    SUBCASE("parameters with D/C low")
    {
        wired.low({0x2A, 0x00});
        CHECK(error() == at(7, "command 0x00 where 0x2A lacks parameters"));
    }
    SUBCASE("pixels without the command to write")
    {
        wired.send(0x2A, {0, 2, 0, 2}).send(0x2B, {0, 1, 0, 1, 0xFF});
        CHECK(error() == at(16, "more parameters than 0x2B has"));
    }
    SUBCASE("columns reversed")
    {
        wired.send(0x2A, {0, 5, 0, 4});
        CHECK(error() == at(10, "columns 5 to 4: reversed"));
    }
    SUBCASE("columns beyond")
    {
        wired.send(0x2A, {0, 2, 0, 132});
        CHECK(error() == at(10, "columns 2 to 132: the last one is 131"));
    }
    SUBCASE("rows beyond")
    {
        wired.send(0x2B, {0, 2, 1, 0});
        CHECK(error() == at(10, "rows 2 to 256: the last one is 161"));
    }
    SUBCASE("columns and rows exchanged: as many columns as there are rows")
    {
        wired.send(0x36, {0x20}).send(0x2A, {0, 0, 0, 161}).send(0x2B, {0, 0, 0, 132});
        CHECK(error() == at(17, "rows 0 to 132: the last one is 131"));
    }
    SUBCASE("no window")
    {
        wired.send(0x2C, {0});
        CHECK(error() == at(7, "pixels before a window is set"));
    }
    SUBCASE("a window from before the memory access was changed")
    {
        window(wired, 2, 2, 1, 1).send(0x36, {0}).send(0x2C, {0});
        CHECK(error() == at(20, "pixels before a window is set"));
    }
    SUBCASE("window overrun")
    {
        window(wired, 2, 2, 1, 1).high({1, 2, 3});
        CHECK(error() == at(19, "more pixels than the window holds"));
    }
    SUBCASE("pixels outside the glass")
    {
        window(wired, 2, 12, 1, 1);
        for (int i = 0; i < 11; ++i)
            colour(wired, 1);
        CHECK(error() == at(38, "a pixel outside the glass: column 12, row 1 of the memory"));
    }
    SUBCASE("half a pixel")
    {
        window(wired, 2, 3, 1, 1).high({1, 2, 3}).low({0x2C});
        CHECK(error() == at(20, "command 0x2C in the middle of a pixel"));
    }
    SUBCASE("asleep")
    {
        window(wired.low({0x10}).wait(5), 2, 2, 1, 1).high({1});
        CHECK(error() == "byte 18 at 245.000 ms: pixels before sleep out");
    }
    SUBCASE("sleep while the window waits")
    {
        colour(window(wired, 2, 3, 1, 1), 1).low({0x10});
        CHECK(error() == at(19, "sleep while the window waits for pixels"));
    }
    SUBCASE("reserved bits of the memory access")
    {
        wired.send(0x36, {0x01});
        CHECK(error() == at(7, "parameter 1 of 0x36 is 0x01, which is not modelled"));
    }
    SUBCASE("scrolling")
    {
        wired.send(0x37, {0, 80});
        CHECK(error() == at(8, "parameter 2 of 0x37 is 0x50, which is not modelled"));
    }
    SUBCASE("data before any command")
    {
        wired.reset().high({0});
        CHECK(error() == at(6, "data before any command"));
    }
    SUBCASE("the first mistake is kept, and nothing is decoded after it")
    {
        wired.low({0x02});
        colour(window(wired, 2, 2, 1, 1), 0xFFFF);
        CHECK(error() == at(6, "unknown command 0x02"));
        CHECK(pixels_of<PixelFormat::rgb565>(wired.model->picture()) == std::vector<int>(60));
    }
}

TEST_CASE("DCS models: the start-up is complete before pixels come")
{
    WiredModel wired{with_glass(Controller::st7789, {1, 1})};
    wired.wait(120);
    SUBCASE("no sleep out")
    {
        window(wired.send(0x36, {0}).send(0x3A, {0x55}).low({0x29}), 0, 0, 0, 0).high({0});
        CHECK(wired.error() == "byte 16 at 120.000 ms: pixels before sleep out");
    }
    SUBCASE("no pixel format")
    {
        wired.low({0x11}).wait(5);
        window(wired.send(0x36, {0}).low({0x29}), 0, 0, 0, 0).high({0});
        CHECK(wired.error() == "byte 15 at 125.000 ms: pixels before 0x3A was given");
    }
    SUBCASE("no memory access")
    {
        wired.low({0x11}).wait(5);
        window(wired.send(0x3A, {0x55}).low({0x29}), 0, 0, 0, 0).high({0});
        CHECK(wired.error() == "byte 15 at 125.000 ms: pixels before 0x36 was given");
    }
    SUBCASE("settings from before a software reset")
    {
        start(wired).low({0x01}).wait(120).low({0x11}).wait(5);
        window(wired.send(0x36, {0}).low({0x29}), 0, 0, 0, 0).high({0});
        CHECK(wired.error() == "byte 22 at 485.000 ms: pixels before 0x3A was given");
    }
}

TEST_CASE("DCS models: each knows the commands of its own vendor, and what they must not change")
{
    const auto error = [](Controller controller, int command, std::initializer_list<int> parameters) {
        WiredModel wired{with_glass(controller, {1, 1})};
        return wired.wait(120).send(command, parameters).low({0x00}).error();
    };
    CHECK(error(Controller::ili9341, 0xB6, {0x08, 0x82, 0x27}) == "none");
    CHECK(error(Controller::ili9341, 0xB6, {0x08, 0xA2, 0x27, 0x00}) == "none");
    CHECK(error(Controller::ili9341, 0xB6, {0x08, 0xC2, 0x27, 0x00}) ==
          "byte 4 at 120.000 ms: parameter 2 of 0xB6 is 0xC2, which is not modelled");
    CHECK(error(Controller::ili9341, 0xF6, {1, 0, 0x20}) ==
          "byte 3 at 120.000 ms: parameter 3 of 0xF6 is 0x20, which is not modelled");
    CHECK(error(Controller::st7789, 0xB0, {0x00, 0xC8}) ==
          "byte 2 at 120.000 ms: parameter 2 of 0xB0 is 0xC8, which is not modelled");
    CHECK(error(Controller::st7789, 0xB0, {0x00, 0xC0}) == "none");
    CHECK(error(Controller::gc9a01, 0xB6, {0x00, 0x20}) == "none");
    CHECK(error(Controller::gc9a01, 0x74, {0x10, 0x85, 0x80, 0, 0, 0x4E, 0}) == "none");
    CHECK(error(Controller::st7735, 0xE0, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}) == "none");
    CHECK(error(Controller::st7735, 0x51, {0}) == "byte 0 at 120.000 ms: unknown command 0x51");
    CHECK(error(Controller::gc9a01, 0xB2, {0}) == "byte 0 at 120.000 ms: unknown command 0xB2");
    CHECK(error(Controller::st7789, 0xCB, {0}) == "byte 0 at 120.000 ms: unknown command 0xCB");
}

}
