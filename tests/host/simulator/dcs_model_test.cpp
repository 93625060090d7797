#include "tests/host/simulator/wired_dcs.hpp"

#include <doctest/doctest.h>

#include <array>
#include <utility>

namespace kfast::test {
namespace {

/// The pixel at the left upper corner of the glass.
int shown(const PanelSettings& settings, std::initializer_list<int> switches, int access, int rgb565)
{
    WiredModel wired{settings};
    start(wired, access);
    for (const int command : switches)
        wired.low({command});
    return glass(colour(window(wired, 0, 0, 0, 0), rgb565))[0];
}

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
    StartedSt7735 wired;
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
    StartedSt7735 wired;
    colour(window(wired.low({0x28}), 2, 2, 1, 1), 0xFFFF);
    CHECK(glass(wired)[0] == 0);
    CHECK(glass(wired.low({0x29}))[0] == 0xFFFF);
}

TEST_CASE("DCS models: writing starts at the corner anew, or goes on")
{
    StartedSt7735 wired;
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

}
