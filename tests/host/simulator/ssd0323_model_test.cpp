#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

struct Model : WiredModel {
    explicit Model(const PanelSettings& settings = facts_of(Controller::ssd0323).default_value)
        : WiredModel{settings}
    {
    }

    Model& commands(std::initializer_list<int> values)
    {
        low(values);
        return *this;
    }
    Model& pixels(std::initializer_list<int> values)
    {
        high(values);
        return *this;
    }
    int grey(int x, int y) const
    {
        return static_cast<int>(pixel_of<PixelFormat::grey4>(model->picture(), x, y));
    }
};

/// What a module needs before the first pixel: 7 bytes.
struct Started : Model {
    explicit Started(int remap = 0x52, int offset = 0x40)
    {
        commands({0xA8, 63, 0xA2, offset, 0xA0, remap, 0xAF});
    }
};

}

TEST_CASE("SSD0323 model: a window is filled row by row, the left pixel from the high nibble")
{
    Started model;
    model.commands({0x15, 16, 17, 0x75, 24, 25}).pixels({0x12, 0x34, 0x56, 0x78});
    CHECK(model.error() == "none");
    for (int i = 0; i < 4; ++i) {
        CHECK(model.grey(32 + i, 24) == 1 + i);
        CHECK(model.grey(32 + i, 25) == 5 + i);
        CHECK(model.grey(32 + i, 26) == 0);
    }
}

TEST_CASE("SSD0323 model: the bytes may come in any portions")
{
    Started model;
    model.commands({0x15}).commands({16}).commands({17, 0x75, 24}).commands({24});
    model.pixels({0x12}).pixels({0x34});
    CHECK(model.error() == "none");
    CHECK(model.grey(34, 24) == 3);
}

TEST_CASE("SSD0323 model: a new window starts at its corner")
{
    Started model;
    model.commands({0x15, 0, 1, 0x75, 0, 1}).pixels({0x11});
    model.commands({0x15, 0, 1, 0x75, 0, 1}).pixels({0x23});
    CHECK(model.grey(0, 0) == 2);
    CHECK(model.grey(1, 0) == 3);
}

TEST_CASE("SSD0323 model: a picture is turned by half with remap and display offset")
{
    for (const int offset : {0x00, 0x50}) {
        Started model{0x41, offset};
        model.commands({0x15, 0, 63, 0x75, 0, 63}).pixels({0x12}).pixels({0x34});
        CHECK(model.error() == "none");
        CHECK(model.grey(127, 63) == 1);
        CHECK(model.grey(126, 63) == 2);
        CHECK(model.grey(125, 63) == 3);
        CHECK(model.grey(124, 63) == 4);
        model.commands({0x15, 63, 63, 0x75, 63, 63}).pixels({0x56});
        CHECK(model.grey(1, 0) == 5);
        CHECK(model.grey(0, 0) == 6);
    }
}

TEST_CASE("SSD0323 model: each bit of the remap mirrors on its own")
{
    struct Corner {
        int remap;
        int offset;
        int x;
        int y;
    };
    for (const Corner& corner :
         {Corner{0x52, 0x40, 0, 0}, Corner{0x50, 0x40, 1, 0}, Corner{0x53, 0x40, 126, 0},
          Corner{0x51, 0x40, 127, 0}, Corner{0x42, 0x00, 0, 63}}) {
        CAPTURE(corner.remap);
        Started model{corner.remap, corner.offset};
        model.commands({0x15, 0, 0, 0x75, 0, 0}).pixels({0xF1});
        CHECK(model.error() == "none");
        CHECK(model.grey(corner.x, corner.y) == 15);
    }
}

TEST_CASE("SSD0323 model: without its display offset a picture is shifted on the glass")
{
    Started model{0x41, 0x40};
    model.commands({0x15, 0, 0, 0x75, 0, 0}).pixels({0xFF});
    CHECK(model.grey(127, 47) == 15);
}

TEST_CASE("SSD0323 model: a glass may have an offset")
{
    Model model{with_glass(Controller::ssd0323, {4, 16}, 8, 3)};
    model.commands({0xA8, 63, 0xA2, 16, 0xA0, 0x52, 0xAF, 0x15, 4, 5, 0x75, 3, 3}).pixels({0x12, 0x34});
    CHECK(model.error() == "none");
    CHECK(model.grey(0, 0) == 1);
    CHECK(model.grey(3, 0) == 4);
    CHECK(model.commands({0x15, 4, 4, 0x75, 2, 2}).pixels({1}).error() ==
          "byte 21 at 0.000 ms: a pixel outside the glass: column 8, row 2 of the memory");
}

TEST_CASE("SSD0323 model: the glass is black while the display is off, and shows what was written then")
{
    Started model;
    model.commands({0x15, 0, 0, 0x75, 0, 0}).pixels({0xFF}).commands({0xAE});
    CHECK(model.grey(0, 0) == 0);
    model.commands({0x15, 0, 0, 0x75, 0, 0}).pixels({0x70});
    CHECK(model.grey(0, 0) == 0);
    CHECK(model.commands({0xAF}).grey(0, 0) == 7);
    CHECK(model.error() == "none");
}

TEST_CASE("SSD0323 model: all dark, all lit, inverted")
{
    Started model;
    model.commands({0x15, 0, 0, 0x75, 0, 0}).pixels({0x3F});
    CHECK(model.commands({0xA7}).grey(0, 0) == 12);
    CHECK(model.commands({0xA5}).grey(0, 0) == 15);
    CHECK(model.commands({0xA6}).grey(1, 0) == 0);
    CHECK(model.commands({0xA4}).grey(0, 0) == 3);
    PanelSettings settings = facts_of(Controller::ssd0323).default_value;
    settings.inverted = true;
    CHECK(Model{settings}.commands({0xA8, 63, 0xA0, 0x52, 0xAF}).grey(0, 0) == 15);
}

TEST_CASE("SSD0323 model: every mistake is named with the place of its byte and its time")
{
    Started model; // 7 bytes
    const auto at = [](int byte, const std::string& what) {
        return "byte " + std::to_string(byte) + " at 0.000 ms: " + what;
    };
    SUBCASE("unknown command")
    {
        CHECK(model.commands({0x15, 0, 1, 0x23}).error() == at(10, "unknown command 0x23"));
    }
    SUBCASE("the time")
    {
        model.wait(1.25);
        CHECK(model.commands({0x23}).error() == "byte 7 at 1.250 ms: unknown command 0x23");
    }
    SUBCASE("parameters missing")
    {
        CHECK(model.commands({0x15, 0}).pixels({0}).error() ==
              at(9, "data where command 0x15 lacks parameters"));
    }
    SUBCASE("no window") { CHECK(model.pixels({0}).error() == at(7, "pixels before a window is set")); }
    SUBCASE("no rows")
    {
        CHECK(model.commands({0x15, 0, 0}).pixels({0}).error() == at(10, "pixels before a window is set"));
    }
    SUBCASE("no columns")
    {
        CHECK(model.commands({0x75, 0, 0}).pixels({0}).error() == at(10, "pixels before a window is set"));
    }
    SUBCASE("window overrun")
    {
        CHECK(model.commands({0x15, 0, 0, 0x75, 0, 1}).pixels({1, 2, 3}).error() ==
              at(15, "more pixels than the window holds"));
    }
    SUBCASE("columns reversed")
    {
        CHECK(model.commands({0x15, 5, 4}).error() == at(9, "columns 5 to 4: reversed"));
    }
    SUBCASE("rows reversed")
    {
        CHECK(model.commands({0x75, 9, 0}).error() == at(9, "rows 9 to 0: reversed"));
    }
    SUBCASE("columns beyond")
    {
        CHECK(model.commands({0x15, 0, 64}).error() == at(9, "columns 0 to 64: the last one is 63"));
    }
    SUBCASE("rows beyond")
    {
        CHECK(model.commands({0x75, 0, 80}).error() == at(9, "rows 0 to 80: the last one is 79"));
    }
    SUBCASE("rows below the glass")
    {
        CHECK(model.commands({0x15, 0, 0, 0x75, 79, 79}).pixels({0xFF}).error() ==
              at(13, "a pixel outside the glass: column 0, row 79 of the memory"));
    }
    SUBCASE("off while the window waits")
    {
        CHECK(model.commands({0x15, 0, 1, 0x75, 0, 0}).pixels({0}).commands({0xAE}).error() ==
              at(14, "sleep while the window waits for pixels"));
    }
    SUBCASE("orientation")
    {
        CHECK(model.commands({0xA0, 0x56}).error() == at(8, "orientation 0x56 is not modelled"));
    }
    SUBCASE("lines not split")
    {
        CHECK(model.commands({0xA0, 0x12}).error() == at(8, "orientation 0x12 is not modelled"));
    }
    SUBCASE("contrast of more than seven bits")
    {
        CHECK(model.commands({0x81, 128}).error() == at(8, "128 is no parameter of 0x81"));
    }
    SUBCASE("too many lines")
    {
        CHECK(model.commands({0xA8, 80}).error() == at(8, "80 is no parameter of 0xA8"));
    }
    SUBCASE("too few lines")
    {
        CHECK(model.commands({0xA8, 14}).error() == at(8, "14 is no parameter of 0xA8"));
    }
    SUBCASE("the first mistake is kept")
    {
        CHECK(model.commands({0x23, 0x24}).pixels({0}).error() == at(7, "unknown command 0x23"));
    }
}

TEST_CASE("SSD0323 model: the start-up is complete before pixels come")
{
    Model model;
    SUBCASE("no orientation")
    {
        CHECK(model.commands({0xA8, 63, 0xAF, 0x15, 0, 0, 0x75, 0, 0}).pixels({0}).error() ==
              "byte 9 at 0.000 ms: pixels before 0xA0 was given");
    }
    SUBCASE("no lines")
    {
        CHECK(model.commands({0xA0, 0x52, 0xAF, 0x15, 0, 0, 0x75, 0, 0}).pixels({0}).error() ==
              "byte 9 at 0.000 ms: pixels before 0xA8 was given");
    }
}

TEST_CASE("SSD0323 model: nothing is decoded after a mistake")
{
    Started model;
    model.commands({0x15, 0, 0, 0x75, 0, 0, 0x23}).pixels({0xFF});
    CHECK(model.grey(0, 0) == 0);
}

}
