#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

#include <array>
#include <utility>

namespace kfast::test {
namespace {

WiredModel& start(WiredModel& wired, int access = 0x00, int format = 0x05)
{
    wired.wait(120).low({0x11}).wait(120);
    return wired.send(0x36, {access}).send(0x3A, {format}).low({0x29});
}

WiredModel& window(WiredModel& wired, int left, int right, int top, int bottom)
{
    const auto range = [&wired](int command, int first, int last) {
        wired.send(command, {first >> 8, first & 255, last >> 8, last & 255});
    };
    range(0x2A, left, right);
    range(0x2B, top, bottom);
    return wired.low({0x2C});
}

WiredModel& colour(WiredModel& wired, int rgb565) { return wired.high({rgb565 >> 8, rgb565 & 255}); }

std::vector<int> glass(const WiredModel& wired)
{
    CHECK(wired.error() == "none");
    return pixels_of<PixelFormat::rgb565>(wired.model->picture());
}

/// The pixel at the left upper corner of the glass.
int shown(const PanelSettings& settings, std::initializer_list<int> switches, int access, int rgb565)
{
    WiredModel wired{settings};
    start(wired, access);
    for (const int command : switches)
        wired.low({command});
    return glass(colour(window(wired, 0, 0, 0, 0), rgb565))[0];
}

/// A started ST7735 with a glass of 10 x 6 at (2, 1).
struct Started : WiredModel {
    Started() : WiredModel{with_glass(Controller::st7735, {10, 6}, 2, 1)} { start(*this); }
};

struct Corners {
    int access;
    /// Column and row, as the window counts.
    std::array<int, 2> left_upper;
    std::array<int, 2> right_lower;
};

constexpr std::array corners{
    Corners{0x00, {2, 1}, {11, 6}},     Corners{0x40, {129, 1}, {120, 6}},
    Corners{0x80, {2, 160}, {11, 155}}, Corners{0xC0, {129, 160}, {120, 155}},
    Corners{0x20, {1, 2}, {6, 11}},     Corners{0x60, {1, 129}, {6, 120}},
    Corners{0xA0, {160, 2}, {155, 11}}, Corners{0xE0, {160, 129}, {155, 120}},
};

}

TEST_CASE("DCS models: every memory access reaches the four corners of a glass with an offset")
{
    for (const Corners& corner : corners) {
        CAPTURE(corner.access);
        const auto& [first, last] = std::pair{corner.left_upper, corner.right_lower};
        WiredModel wired{with_glass(Controller::st7735, {10, 6}, 2, 1)};
        start(wired, corner.access);
        const auto paint = [&wired](int column, int row, int rgb565) {
            colour(window(wired, column, column, row, row), rgb565);
        };
        const bool is_exchanged = (corner.access & 0x20) != 0;
        paint(first[0], first[1], 1);
        paint(is_exchanged ? first[0] : last[0], is_exchanged ? last[1] : first[1], 2);
        paint(is_exchanged ? last[0] : first[0], is_exchanged ? first[1] : last[1], 3);
        paint(last[0], last[1], 4);

        std::vector<int> expected(60);
        expected[0] = 1;
        expected[9] = 2;
        expected[50] = 3;
        expected[59] = 4;
        CHECK(glass(wired) == expected);
    }
}

TEST_CASE("DCS models: a turned window is filled as the upright picture is read")
{
    struct Turn {
        Rotation rotation;
        int access;
        std::array<int, 4> window; ///< of a glass of 3 x 2 at (2, 1): left, right, top, bottom
    };
    for (const Turn& turn :
         {Turn{Rotation::none, 0x00, {2, 4, 1, 2}}, Turn{Rotation::quarter, 0x60, {1, 2, 127, 129}},
          Turn{Rotation::half, 0xC0, {127, 129, 159, 160}},
          Turn{Rotation::three_quarters, 0xA0, {159, 160, 2, 4}}}) {
        CAPTURE(turn.access);
        WiredModel wired{with_glass(Controller::st7735, {3, 2}, 2, 1)};
        start(wired, turn.access);
        window(wired, turn.window[0], turn.window[1], turn.window[2], turn.window[3]);
        for (const int number : counted(6))
            colour(wired, number);
        CHECK(wired.error() == "none");
        const Frame upright = seen_upright(wired.model->picture(), turn.rotation);
        CHECK(upright.size == (lies_across(turn.rotation) ? Size{2, 3} : Size{3, 2}));
        CHECK(pixels_of<PixelFormat::rgb565>(upright) == counted(6));
    }
}

TEST_CASE("DCS models: the colours are those of the glass")
{
    PanelSettings plain = with_glass(Controller::st7789, {1, 1});
    PanelSettings swapped = plain;
    swapped.bgr = true;
    PanelSettings inverted = plain;
    inverted.inverted = true;

    CHECK(shown(plain, {}, 0x00, 0xF801) == 0xF801);
    CHECK(shown(plain, {}, 0x08, 0xF801) == 0x081F);
    CHECK(shown(swapped, {}, 0x00, 0xF801) == 0x081F);
    CHECK(shown(swapped, {}, 0x08, 0xF801) == 0xF801);
    CHECK(shown(plain, {0x21}, 0x00, 0xF801) == 0x07FE);
    CHECK(shown(plain, {0x21, 0x20}, 0x00, 0xF801) == 0xF801);
    CHECK(shown(inverted, {}, 0x00, 0xF801) == 0x07FE);
    CHECK(shown(inverted, {0x21}, 0x00, 0xF801) == 0xF801);
}

TEST_CASE("DCS models: pixels have 12, 16 or 18 bits")
{
    WiredModel wired{with_glass(Controller::st7789, {2, 1})};
    SUBCASE("12: two in three bytes")
    {
        start(wired, 0, 0x53);
        window(wired, 0, 1, 0, 0).high({0xF8, 0x13, 0x7F});
        CHECK(glass(wired) == std::vector{0xFC42, 0x33BF});
    }
    SUBCASE("16")
    {
        start(wired, 0, 0x55);
        window(wired, 0, 1, 0, 0).high({0x12, 0x34, 0xFE, 0xDC});
        CHECK(glass(wired) == std::vector{0x1234, 0xFEDC});
    }
    SUBCASE("18: one in the upper bits of three bytes")
    {
        start(wired, 0, 0x66);
        window(wired, 0, 1, 0, 0).high({0xF8, 0x04, 0x0B, 0x03, 0xFF, 0x80});
        CHECK(glass(wired) == std::vector{0xF821, 0x07F0});
    }
}

TEST_CASE("DCS models: not every controller has every pixel format")
{
    const auto error = [](Controller controller, int format) {
        WiredModel wired{with_glass(controller, {2, 1})};
        return start(wired, 0, format).error().substr(0, 4);
    };
    for (const int format : {0x05, 0x55, 0x65, 0x06, 0x66})
        for (const Controller controller : {Controller::st7789, Controller::ili9341, Controller::gc9a01})
            CHECK(error(controller, format) == "none");
    CHECK(error(Controller::st7789, 0x53) == "none");
    CHECK(error(Controller::st7735, 0x03) == "none");
    CHECK(error(Controller::ili9341, 0x53) == "byte");
    CHECK(error(Controller::gc9a01, 0x03) == "byte");
    CHECK(error(Controller::st7735, 0x55) == "none");
    CHECK(error(Controller::st7735, 0x04) == "byte");
    CHECK(error(Controller::st7789, 0x07) == "byte");
    CHECK(error(Controller::st7789, 0x75) == "byte");
}

TEST_CASE("DCS models: the glass is black while it is asleep or off")
{
    Started wired;
    colour(window(wired, 2, 2, 1, 1), 0xFFFF);
    CHECK(glass(wired)[0] == 0xFFFF);
    wired.low({0x28});
    CHECK(glass(wired)[0] == 0);
    wired.low({0x29}).low({0x10});
    CHECK(glass(wired)[0] == 0);
    wired.wait(120).low({0x11});
    CHECK(glass(wired)[0] == 0xFFFF);
    wired.reset();
    CHECK(glass(wired)[0] == 0);
}

TEST_CASE("DCS models: what is written while the glass is dark is seen when it is lit")
{
    Started wired;
    colour(window(wired.low({0x28}), 2, 2, 1, 1), 0xFFFF);
    CHECK(glass(wired)[0] == 0);
    CHECK(glass(wired.low({0x29}))[0] == 0xFFFF);
}

TEST_CASE("DCS models: writing starts at the corner anew, or goes on")
{
    Started wired;
    colour(window(wired, 2, 3, 1, 1), 1);
    SUBCASE("anew")
    {
        colour(colour(wired.low({0x2C}), 2), 3);
        CHECK(glass(wired)[0] == 2);
        CHECK(glass(wired)[1] == 3);
    }
    SUBCASE("the bytes in any portions, with other commands between")
    {
        WiredModel later{with_glass(Controller::st7789, {2, 1})};
        start(later);
        window(later, 0, 1, 0, 0).high({0}).high({7, 0}).high({8});
        CHECK(glass(later) == std::vector{7, 8});
        window(later, 0, 1, 0, 0).high({0, 1}).send(0x51, {9}).low({0x3C}).high({0, 2});
        CHECK(glass(later) == std::vector{1, 2});
    }
}

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
    Started wired; // 6 bytes, 240 ms
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

TEST_CASE("DCS models: reset and sleep take their time")
{
    WiredModel wired{with_glass(Controller::st7789, {1, 1})};
    SUBCASE("after the power came on")
    {
        CHECK(wired.wait(4.999).low({0x00}).error() ==
              "byte 0 at 4.999 ms: command 0x00 too soon after reset or sleep");
    }
    SUBCASE("5 ms are enough for most") { CHECK(wired.wait(5).low({0x00}).error() == "none"); }
    SUBCASE("but not for sleep out")
    {
        CHECK(wired.wait(119.999).low({0x11}).error() ==
              "byte 0 at 119.999 ms: sleep out too soon: 120 ms pass after reset or sleep in");
    }
    SUBCASE("after the reset line")
    {
        wired.wait(1000).reset();
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 0 at 1004.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep out")
        {
            CHECK(wired.wait(119).low({0x11}).error() ==
                  "byte 0 at 1119.000 ms: sleep out too soon: 120 ms pass after reset or sleep in");
        }
    }
    SUBCASE("after a software reset")
    {
        wired.wait(1000).low({0x01});
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 1 at 1004.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep out")
        {
            CHECK(wired.wait(119).low({0x11}).error() ==
                  "byte 1 at 1119.000 ms: sleep out too soon: 120 ms pass after reset or sleep in");
        }
    }
    SUBCASE("after sleep out")
    {
        wired.wait(120).low({0x11});
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 1 at 124.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep in")
        {
            CHECK(wired.wait(119).low({0x10}).error() ==
                  "byte 1 at 239.000 ms: 0x10 too soon: 120 ms pass after sleep out");
        }
        SUBCASE("software reset")
        {
            CHECK(wired.wait(119).low({0x01}).error() ==
                  "byte 1 at 239.000 ms: 0x01 too soon: 120 ms pass after sleep out");
        }
        SUBCASE("which is heard once")
        {
            CHECK(wired.wait(100).low({0x11}).wait(20).low({0x10}).error() == "none");
        }
    }
    SUBCASE("after sleep in")
    {
        wired.wait(120).low({0x11}).wait(120).low({0x10});
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 2 at 244.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep out")
        {
            CHECK(wired.wait(119).low({0x11}).error() ==
                  "byte 2 at 359.000 ms: sleep out too soon: 120 ms pass after reset or sleep in");
        }
        SUBCASE("and all is well after 120 ms") { CHECK(wired.wait(120).low({0x11}).error() == "none"); }
    }
}

TEST_CASE("ST7735 model: hears nothing for 120 ms after reset and sleep out")
{
    WiredModel wired{with_glass(Controller::st7735, {1, 1})};
    SUBCASE("reset")
    {
        CHECK(wired.wait(119).low({0x00}).error() ==
              "byte 0 at 119.000 ms: command 0x00 too soon after reset or sleep");
    }
    SUBCASE("sleep out")
    {
        CHECK(wired.wait(120).low({0x11}).wait(119).low({0x00}).error() ==
              "byte 1 at 239.000 ms: command 0x00 too soon after reset or sleep");
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
