#include "host/simulator/ssd0323_model.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

struct Model : Ssd0323Model {
    Model& commands(std::initializer_list<int> values)
    {
        command(bytes(values));
        return *this;
    }
    Model& pixels(std::initializer_list<int> values)
    {
        data(bytes(values));
        return *this;
    }
    int grey(int x, int y) const { return picture()[static_cast<std::size_t>(y * width + x)]; }
};

}

TEST_CASE("SSD0323 model: a window is filled row by row, the left pixel from the high nibble")
{
    Model model;
    model.commands({0xAF, 0x15, 16, 17, 0x75, 24, 25}).pixels({0x12, 0x34, 0x56, 0x78});
    CHECK_FALSE(model.error().has_value());
    for (int i = 0; i < 4; ++i) {
        CHECK(model.grey(32 + i, 24) == 1 + i);
        CHECK(model.grey(32 + i, 25) == 5 + i);
        CHECK(model.grey(32 + i, 26) == 0);
    }
}

TEST_CASE("SSD0323 model: the bytes may come in any portions")
{
    Model model;
    model.commands({0xAF, 0x15}).commands({16}).commands({17, 0x75, 24}).commands({24});
    model.pixels({0x12}).pixels({0x34});
    CHECK_FALSE(model.error().has_value());
    CHECK(model.grey(34, 24) == 3);
}

TEST_CASE("SSD0323 model: a new window starts at its corner")
{
    Model model;
    model.commands({0xAF, 0x15, 0, 1, 0x75, 0, 1}).pixels({0x11});
    model.commands({0x15, 0, 1, 0x75, 0, 1}).pixels({0x23});
    CHECK(model.grey(0, 0) == 2);
    CHECK(model.grey(1, 0) == 3);
}

TEST_CASE("SSD0323 model: rows below the glass exist but are not seen")
{
    Model model;
    model.commands({0xAF, 0x15, 0, 0, 0x75, 79, 79}).pixels({0xFF});
    CHECK_FALSE(model.error().has_value());
    CHECK(model.picture() == Ssd0323Model{}.picture());
}

TEST_CASE("SSD0323 model: the glass is black while the display is off")
{
    Model model;
    model.commands({0xAF, 0x15, 0, 0, 0x75, 0, 0}).pixels({0xFF}).commands({0xAE});
    CHECK(model.grey(0, 0) == 0);
}

TEST_CASE("SSD0323 model: every mistake is named with the place of its byte")
{
    const auto error = [](Model& model) { return model.error().value_or("none"); };
    Model model;
    SUBCASE("unknown command")
    {
        CHECK(error(model.commands({0xAF, 0x15, 0, 1, 0x23})) == "byte 4: unknown command 0x23");
    }
    SUBCASE("parameters missing")
    {
        CHECK(error(model.commands({0xAF, 0x15, 0}).pixels({0})) ==
              "byte 3: data where command 0x15 lacks parameters");
    }
    SUBCASE("no window")
    {
        CHECK(error(model.commands({0xAF}).pixels({0})) == "byte 1: pixels before a window is set");
    }
    SUBCASE("no rows")
    {
        CHECK(error(model.commands({0xAF, 0x15, 0, 0}).pixels({0})) ==
              "byte 4: pixels before a window is set");
    }
    SUBCASE("no columns")
    {
        CHECK(error(model.commands({0xAF, 0x75, 0, 0}).pixels({0})) ==
              "byte 4: pixels before a window is set");
    }
    SUBCASE("window overrun")
    {
        CHECK(error(model.commands({0xAF, 0x15, 0, 0, 0x75, 0, 1}).pixels({1, 2, 3})) ==
              "byte 9: more pixels than the window holds");
    }
    SUBCASE("columns reversed")
    {
        CHECK(error(model.commands({0x15, 5, 4})) == "byte 2: columns 5 to 4: reversed");
    }
    SUBCASE("rows reversed")
    {
        CHECK(error(model.commands({0x75, 9, 0})) == "byte 2: rows 9 to 0: reversed");
    }
    SUBCASE("columns beyond")
    {
        CHECK(error(model.commands({0x15, 0, 64})) == "byte 2: columns 0 to 64: the last one is 63");
    }
    SUBCASE("rows beyond")
    {
        CHECK(error(model.commands({0x75, 0, 80})) == "byte 2: rows 0 to 80: the last one is 79");
    }
    SUBCASE("display off")
    {
        CHECK(error(model.commands({0x15, 0, 0, 0x75, 0, 0}).pixels({0})) ==
              "byte 6: pixels before the display is on");
    }
    SUBCASE("orientation")
    {
        CHECK(error(model.commands({0xA0, 0x56})) == "byte 1: orientation 0x56 is not modelled");
    }
    SUBCASE("the first mistake is kept")
    {
        CHECK(error(model.commands({0x23, 0x24}).pixels({0})) == "byte 0: unknown command 0x23");
    }
}

TEST_CASE("SSD0323 model: nothing is decoded after a mistake")
{
    Model model;
    model.commands({0xAF, 0x15, 0, 0, 0x75, 0, 0, 0x23}).pixels({0xFF});
    CHECK(model.grey(0, 0) == 0);
}

}
