#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("an arc is open and runs clockwise from three o'clock when its angles rise")
{
    CHECK(drawn("arc 20 30 r=16 from=0 to=90") == "M 36 30 C 36 38.8125 28.8125 46 20 46");
    CHECK(drawn("arc 20 30 r=16 from=-90 to=0") == "M 20 14 C 28.8125 14 36 21.1875 36 30");
    CHECK(drawn("arc 20 30 r=16 from=0 to=-90") == "M 36 30 C 36 21.1875 28.8125 14 20 14");
    CHECK(drawn("arc 20 30 r=16 from=360 to=450") == drawn("arc 20 30 r=16 from=0 to=90"));
}

TEST_CASE("an arc of a whole turn is a circle, one of none a point")
{
    CHECK(drawn("arc 20 30 r=16 from=0 to=360") == drawn("circle 20 30 r=16"));
    CHECK(drawn("arc 20 30 r=16 from=30 to=30") == "M 33.875 38");
}

TEST_CASE("an arc has cubics of at most a quarter turn")
{
    CHECK(drawn("arc 20 30 r=16 from=0 to=91") ==
          "M 36 30 C 36 34.3125 34.25 38.375 31.1875 41.4375 C 28.125 44.4375 24 46.0625 19.75 46");
    // As doubles, these are a hair more than 90 apart.
    CHECK(drawn("arc 20 30 r=16 from=38.3 to=128.3") ==
          "M 32.5625 39.9375 C 27.0625 46.875 17 48.0625 10.0625 42.5625");
}

TEST_CASE("an arc may be a piece of an ellipse")
{
    CHECK(drawn("arc 20 30 rx=32 ry=16 from=90 to=270") ==
          "M 20 46 C 2.3125 46 -12 38.8125 -12 30 C -12 21.1875 2.3125 14 20 14");
}

TEST_CASE("a pie is closed through its centre, where it begins")
{
    CHECK(drawn("pie 20 30 r=16 from=0 to=90") == "M 20 30 L 36 30 C 36 38.8125 28.8125 46 20 46 L 20 30");
    CHECK(drawn("pie 20 30 r=16 from=90 to=0") == "M 20 30 L 20 46 C 28.8125 46 36 38.8125 36 30 L 20 30");
    CHECK(drawn("pie 20 30 r=16 from=0 to=0") == "M 20 30 L 36 30 L 20 30");
}

TEST_CASE("a pie with an inner radius is a piece of a ring, from where its arc begins")
{
    CHECK(drawn("pie 20 30 r=16 from=0 to=90 inner=8") == "M 36 30 C 36 38.8125 28.8125 46 20 46"
                                                          " L 20 38 C 24.4375 38 28 34.4375 28 30 L 36 30");
    CHECK(drawn("pie 20 30 r=16 from=0 to=90 inner=0") ==
          "M 36 30 C 36 38.8125 28.8125 46 20 46 L 20 30 L 36 30");
}

TEST_CASE("arcs and pies of another form are refused")
{
    CHECK(drawn("arc 1 2 r=3 from=0") == "1:1 error: arc needs the property \"to\" (add to=…)");
    CHECK(drawn("arc 1 2 from=0 to=36") == "1:1 error: arc needs the property \"r\" (add r=…)");
    CHECK(drawn("arc 1 2 rx=4 from=0 to=36") == "1:1 error: arc needs the property \"ry\" (add ry=…)");
    CHECK(drawn("arc 1 2 r=3 rx=4 ry=4 from=0 to=36") ==
          "1:9 error: arc has no property \"r\" (allowed: rx, ry, from, to)");
    CHECK(drawn("arc 1 2 r=3 from=0 to=36 inner=1") ==
          "1:26 error: arc has no property \"inner\" (allowed: r, from, to)");
    CHECK(drawn("arc 1 2 r=3 from=-1 to=360") == "1:1 error: this arc goes round more than once "
                                                 "(keep from and to within 360 degrees of each other)");
    CHECK(drawn("pie 1 2 r=3 from=400 to=0") == "1:1 error: this pie goes round more than once "
                                                "(keep from and to within 360 degrees of each other)");
    CHECK(drawn("pie 1 2 r=3 from=4000 to=0") ==
          "1:18 error: this number is out of range (allowed: -3600 to 3600)");
    CHECK(drawn("pie 2040 2 r=30 from=0 to=20") ==
          "1:1 error: this pie reaches more than 2047 px from the origin");
}

}
