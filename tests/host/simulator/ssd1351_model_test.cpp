#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

#include <array>

namespace kfast::test {
namespace {

WiredModel& start(WiredModel& wired, int remap = 0x74, int last_line = 127)
{
    wired.send(0xFD, {0x12}).send(0xFD, {0xB1}).send(0xA0, {remap}).send(0xCA, {last_line});
    return wired.send(0xA1, {0}).send(0xA2, {0}).low({0xA6}).low({0xAF});
}

WiredModel& window(WiredModel& wired, int left, int right, int top, int bottom)
{
    return wired.send(0x15, {left, right}).send(0x75, {top, bottom}).low({0x5C});
}

std::vector<int> glass(const WiredModel& wired)
{
    CHECK(wired.error() == "none");
    return pixels_of<PixelFormat::rgb565>(wired.model->picture());
}

/// A started one with a glass of 3 x 2 at (4, 5); 16 bytes.
struct Started : WiredModel {
    Started() : WiredModel{with_glass(Controller::ssd1351, {3, 2}, 4, 5)} { start(*this); }
};

int shown(const PanelSettings& settings, int mode, int remap)
{
    WiredModel wired{settings};
    window(start(wired, remap).low({mode}), 0, 0, 0, 0).high({0xF8, 0x01});
    return glass(wired)[0];
}

}

TEST_CASE("SSD1351 model: every remap reaches the four corners of a glass with an offset")
{
    struct Mirrors {
        int remap;
        std::array<int, 2> columns; ///< of the left and the right edge of the glass
        std::array<int, 2> rows;    ///< of its upper and lower edge
    };
    for (const Mirrors& mirrors :
         {Mirrors{0x74, {4, 6}, {5, 6}}, Mirrors{0x76, {123, 121}, {5, 6}}, Mirrors{0x64, {4, 6}, {122, 121}},
          Mirrors{0x66, {123, 121}, {122, 121}}}) {
        for (const int rows_first : {0, 1}) {
            CAPTURE(mirrors.remap);
            WiredModel wired{with_glass(Controller::ssd1351, {3, 2}, 4, 5)};
            start(wired, mirrors.remap | rows_first);
            int number = 0;
            for (const int row : mirrors.rows)
                for (const int column : mirrors.columns)
                    window(wired, column, column, row, row).high({0, ++number});
            CHECK(glass(wired) == std::vector{1, 0, 2, 3, 0, 4});
        }
    }
}

TEST_CASE("SSD1351 model: a turned window is filled as the upright picture is read")
{
    struct Turn {
        Rotation rotation;
        int remap;
        std::array<int, 4> window; ///< left, right, top, bottom
    };
    for (const Turn& turn :
         {Turn{Rotation::none, 0x74, {4, 6, 5, 6}}, Turn{Rotation::quarter, 0x77, {121, 123, 5, 6}},
          Turn{Rotation::half, 0x66, {121, 123, 121, 122}},
          Turn{Rotation::three_quarters, 0x65, {4, 6, 121, 122}}}) {
        CAPTURE(turn.remap);
        WiredModel wired{with_glass(Controller::ssd1351, {3, 2}, 4, 5)};
        start(wired, turn.remap);
        window(wired, turn.window[0], turn.window[1], turn.window[2], turn.window[3]);
        for (const int number : counted(6))
            wired.high({0, number});
        CHECK(wired.error() == "none");
        const Frame upright = seen_upright(wired.model->picture(), turn.rotation);
        CHECK(pixels_of<PixelFormat::rgb565>(upright) == counted(6));
    }
}

TEST_CASE("SSD1351 model: the colours are those of the glass")
{
    PanelSettings plain = with_glass(Controller::ssd1351, {1, 1});
    PanelSettings swapped = plain;
    swapped.bgr = true;
    PanelSettings inverted = plain;
    inverted.inverted = true;
    CHECK(shown(plain, 0xA6, 0x74) == 0xF801);
    CHECK(shown(plain, 0xA6, 0x70) == 0x081F);
    CHECK(shown(swapped, 0xA6, 0x70) == 0xF801);
    CHECK(shown(plain, 0xA7, 0x74) == 0x07FE);
    CHECK(shown(inverted, 0xA7, 0x74) == 0xF801);
    CHECK(shown(plain, 0xA4, 0x74) == 0);
    CHECK(shown(plain, 0xA5, 0x74) == 0xFFFF);
}

TEST_CASE("SSD1351 model: 18 bits in the lower bits of three bytes")
{
    WiredModel wired{with_glass(Controller::ssd1351, {1, 1})};
    window(start(wired, 0xB4), 0, 0, 0, 0).high({0x3E, 0x01, 0x03});
    CHECK(glass(wired) == std::vector{0xF821});
}

TEST_CASE("SSD1351 model: lines and start line choose the rows that are shown")
{
    WiredModel wired{with_glass(Controller::ssd1351, {1, 96})};
    start(wired, 0x74, 95);
    window(wired, 0, 0, 0, 1).high({0, 1, 0, 2});
    CHECK(glass(wired)[0] == 1);
    wired.send(0xA1, {1});
    CHECK(glass(wired)[0] == 2);
    wired.send(0xA1, {0}).send(0xA0, {0x64});
    CHECK(glass(wired)[95] == 1);
    CHECK(glass(wired)[94] == 2);
}

TEST_CASE("SSD1351 model: the glass is black while it is off, and shows what was written then")
{
    Started wired;
    window(wired, 4, 4, 5, 5).high({0xFF, 0xFF});
    CHECK(glass(wired)[0] == 0xFFFF);
    wired.low({0xAE});
    CHECK(glass(wired)[0] == 0);
    window(wired, 4, 4, 5, 5).high({0x12, 0x34});
    CHECK(glass(wired)[0] == 0);
    CHECK(glass(wired.low({0xAF}))[0] == 0x1234);
}

TEST_CASE("SSD1351 model: every mistake is named with the place of its byte")
{
    Started wired; // 14 bytes
    const auto error = [&wired] { return wired.error().substr(wired.error().find(": ") + 2); };
    SUBCASE("the place")
    {
        CHECK(wired.wait(1.5).low({0x23}).error() == "byte 14 at 1.500 ms: unknown command 0x23");
    }
    SUBCASE("parameters missing")
    {
        wired.send(0x15, {4}).low({0x75});
        CHECK(error() == "command 0x75 where 0x15 lacks parameters");
    }
    SUBCASE("too many parameters")
    {
        wired.send(0x15, {4, 5, 6});
        CHECK(error() == "more parameters than 0x15 has");
    }
    SUBCASE("reading")
    {
        wired.low({0x5D});
        CHECK(error() == "command 0x5D is not modelled");
    }
    SUBCASE("rows beyond")
    {
        wired.send(0x75, {0, 128});
        CHECK(error() == "rows 0 to 128: the last one is 127");
    }
    SUBCASE("columns reversed")
    {
        wired.send(0x15, {6, 5});
        CHECK(error() == "columns 6 to 5: reversed");
    }
    SUBCASE("writing without new columns")
    {
        window(wired, 4, 4, 5, 5).high({0, 1}).send(0x75, {5, 5}).low({0x5C});
        CHECK(error() == "0x5C without new columns and rows");
    }
    SUBCASE("writing without new rows")
    {
        window(wired, 4, 4, 5, 5).high({0, 1}).send(0x15, {4, 4}).low({0x5C});
        CHECK(error() == "0x5C without new columns and rows");
    }
    SUBCASE("window overrun")
    {
        window(wired, 4, 4, 5, 5).high({0, 1, 0});
        CHECK(error() == "more pixels than the window holds");
    }
    SUBCASE("outside the glass")
    {
        window(wired, 7, 7, 5, 5).high({0, 1});
        CHECK(error() == "a pixel outside the glass: column 7, row 5 of the memory");
    }
    SUBCASE("half a pixel")
    {
        window(wired, 4, 4, 5, 5).high({0}).low({0x15});
        CHECK(error() == "command 0x15 in the middle of a pixel");
    }
    SUBCASE("off while the window waits")
    {
        window(wired, 4, 5, 5, 5).high({0, 1}).low({0xAE});
        CHECK(error() == "sleep while the window waits for pixels");
    }
    SUBCASE("256 colours")
    {
        wired.send(0xA0, {0x34});
        CHECK(error() == "remap 0x34 is not modelled");
    }
    SUBCASE("lines not split")
    {
        wired.send(0xA0, {0x54});
        CHECK(error() == "remap 0x54 is not modelled");
    }
    SUBCASE("display offset")
    {
        wired.send(0xA2, {0x60});
        CHECK(error() == "a display offset of 96 is not modelled");
    }
    SUBCASE("start line")
    {
        wired.send(0xA1, {128});
        CHECK(error() == "the start line is 128: the last one is 127");
    }
    SUBCASE("too few lines")
    {
        wired.send(0xCA, {14});
        CHECK(error() == "the last line is 14: it lies between 15 and 127");
    }
    SUBCASE("too much current")
    {
        wired.send(0xC7, {16});
        CHECK(error() == "the master current is 16: the largest is 15");
    }
    SUBCASE("locked")
    {
        wired.send(0xFD, {0x16}).low({0xA6});
        CHECK(error() == "command 0xA6 while the commands are locked");
    }
    SUBCASE("a wrong key")
    {
        wired.send(0xFD, {0x11});
        CHECK(error() == "the lock has no key 0x11");
    }
}

TEST_CASE("SSD1351 model: the start-up is complete before pixels come")
{
    WiredModel wired{with_glass(Controller::ssd1351, {1, 1})};
    const auto error = [&wired] { return wired.error().substr(wired.error().find(": ") + 2); };
    SUBCASE("inner commands are locked after a reset")
    {
        wired.send(0xFD, {0x12}).low({0xB3});
        CHECK(error() == "command 0xB3 before 0xFD with 0xB1 has opened it");
    }
    SUBCASE("no display offset")
    {
        wired.send(0xA0, {0x74}).send(0xCA, {127}).low({0xAF});
        window(wired, 0, 0, 0, 0).high({0});
        CHECK(error() == "pixels before 0xA2 was given");
    }
    SUBCASE("no remap")
    {
        wired.send(0xFD, {0xB1}).send(0xA2, {0}).send(0xCA, {127}).low({0xAF});
        window(wired, 0, 0, 0, 0).high({0});
        CHECK(error() == "pixels before 0xA0 was given");
    }
    SUBCASE("settings from before a reset")
    {
        window(start(wired).reset().low({0xAF}), 0, 0, 0, 0).high({0});
        CHECK(error() == "pixels before 0xA0 was given");
    }
}

}
