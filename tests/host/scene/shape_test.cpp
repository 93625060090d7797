#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

// The control points of a quarter of a circle lie 0.5523 radii along its tangents: 8.8366 for a radius of 16,
// 8.8125 in 1/16 px.

TEST_CASE("a circle runs from three o'clock, clockwise")
{
    CHECK(drawn("circle 20 30 r=16") == "M 36 30"
                                        " C 36 38.8125 28.8125 46 20 46"
                                        " C 11.1875 46 4 38.8125 4 30"
                                        " C 4 21.1875 11.1875 14 20 14"
                                        " C 28.8125 14 36 21.1875 36 30");
    CHECK(drawn("circle 20 30 r=0") == "M 20 30");
}

TEST_CASE("an ellipse has a radius for each axis")
{
    CHECK(drawn("ellipse 20 30 ry=32 rx=16") == "M 36 30"
                                                " C 36 47.6875 28.8125 62 20 62"
                                                " C 11.1875 62 4 47.6875 4 30"
                                                " C 4 12.3125 11.1875 -2 20 -2"
                                                " C 28.8125 -2 36 12.3125 36 30");
}

TEST_CASE("a rectangle runs from its upper left corner, clockwise")
{
    CHECK(drawn("rect 1 2 30 40") == "M 1 2 L 31 2 L 31 42 L 1 42 L 1 2");
    CHECK(drawn("rect 1 2 30 0") == "M 1 2 L 31 2 L 1 2");
    CHECK(drawn("rect 1 2 0 0") == "M 1 2");
}

TEST_CASE("a rectangle with round corners begins behind the first of them")
{
    CHECK(drawn("rect 0 0 50 40 corner=16") == "M 16 0 L 34 0"
                                               " C 42.8125 0 50 7.1875 50 16 L 50 24"
                                               " C 50 32.8125 42.8125 40 34 40 L 16 40"
                                               " C 7.1875 40 0 32.8125 0 24 L 0 16"
                                               " C 0 7.1875 7.1875 0 16 0");
}

TEST_CASE("corners are cut to half of the side, each axis by itself as in SVG")
{
    CHECK(drawn("rect 0 0 64 16 corner=16") == "M 16 0 L 48 0"
                                               " C 56.8125 0 64 3.5625 64 8"
                                               " C 64 12.4375 56.8125 16 48 16 L 16 16"
                                               " C 7.1875 16 0 12.4375 0 8"
                                               " C 0 3.5625 7.1875 0 16 0");
}

TEST_CASE("a polygon is closed, a line is not")
{
    CHECK(drawn("polygon 1 2 3 4 5 0") == "M 1 2 L 3 4 L 5 0 L 1 2");
    CHECK(drawn("polygon 1 2 3 4 5 0 1 2") == "M 1 2 L 3 4 L 5 0 L 1 2");
    CHECK(drawn("line 1 2 3 4") == "M 1 2 L 3 4");
    CHECK(drawn("line 1 2 3 4 5 0 1 2.5") == "M 1 2 L 3 4 L 5 0 L 1 2.5");
}

TEST_CASE("coordinates are rounded once to 1/16 px, halves away from zero")
{
    CHECK(drawn("line 0.03125 -0.03125 0.03124 -0.03124") == "M 0.0625 -0.0625 L 0 0");
    CHECK(drawn("line 2047 -2047 9.99 -9.99") == "M 2047 -2047 L 10 -10");
}

TEST_CASE("segments without extent are dropped, down to a single point")
{
    CHECK(drawn("line 1 1 1.01 1.01 2 2 2 2") == "M 1 1 L 2 2");
    CHECK(drawn("line 1 1 1 1 1 1") == "M 1 1");
    CHECK(drawn("polygon 1 1 5 1 5 5 1.02 1.02") == "M 1 1 L 5 1 L 5 5 L 1 1");
    CHECK(drawn("circle 3 3 r=0.01") == "M 3 3");
}

TEST_CASE("shapes of another form are refused")
{
    CHECK(drawn("circle 1 r=2") == "1:1 error: circle needs more values (write circle CX CY r=RADIUS)");
    CHECK(drawn("circle 1 2 3") ==
          "1:12 error: this value is too many for circle (write circle CX CY r=RADIUS)");
    CHECK(drawn("circle 1 2") == "1:1 error: circle needs the property \"r\" (add r=…)");
    CHECK(drawn("circle 1 2 R=3") == "1:1 error: circle needs the property \"r\" (add r=…)\n"
                                     "1:12 error: circle has no property \"R\" (KFAST calls it \"r\")");
    CHECK(drawn("circle 1 2 r=3 { x }") ==
          "1:18 error: circle takes no nodes inside (write circle CX CY r=RADIUS)");
    CHECK(drawn("ellipse 1 2 rx=3") == "1:1 error: ellipse needs the property \"ry\" (add ry=…)");
    CHECK(drawn("rect 1 2 3") ==
          "1:1 error: rect needs more values (write rect X Y WIDTH HEIGHT corner=RADIUS)");
    CHECK(drawn("rect 1 2 3 4 corners=1") ==
          "1:14 error: rect has no property \"corners\" (did you mean \"corner\"?)");
    CHECK(drawn("polygon 1 2 3 4") == "1:1 error: polygon needs more values (write polygon X Y X Y X Y …)");
    CHECK(drawn("polygon 1 2 3 4 5 6 7") == "1:21 error: this x has no y (add the y, or remove this x)");
    CHECK(drawn("line 1 2") == "1:1 error: line needs more values (write line X Y X Y …)");
    CHECK(drawn("line 1 2 3 4 5") == "1:14 error: this x has no y (add the y, or remove this x)");
    CHECK(drawn("line 1 2 3 4 w=5") == "1:14 error: line has no property \"w\" (nothing is allowed here)");
    CHECK(drawn("path M L") == "1:8 error: this value is too many for path (write path \"M … L …\")");
    CHECK(drawn("path 5") == "1:6 error: a word or a text in quotes is expected here");
}

TEST_CASE("numbers out of range are refused where they are")
{
    CHECK(drawn("circle 1 2048 r=1") == "1:10 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(drawn("circle 1 2 r=-1") == "1:14 error: this number is out of range (allowed: 0 to 4094)");
    CHECK(drawn("circle 2000 2 r=48") == "1:1 error: this circle reaches more than 2047 px from the origin");
    CHECK(drawn("circle 1 -1999 r=48.5") ==
          "1:1 error: this circle reaches more than 2047 px from the origin");
    CHECK(drawn("rect -2000 0 4047.5 1") == "1:1 error: this rect reaches more than 2047 px from the origin");
    CHECK(drawn("line 1 2 #nan 4") == "1:10 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(drawn("line 1 2 #-inf 4") == "1:10 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(drawn("line 1 two 3 4") == "1:8 error: a number is expected here");
    CHECK(drawn("rect -2047 -2047 4094 4094") ==
          "M -2047 -2047 L 2047 -2047 L 2047 2047 L -2047 2047 L -2047 -2047");
}

}
