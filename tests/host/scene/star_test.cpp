#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

// 16 sin 60 is 13.8564, 13.875 in 1/16 px; 8 sin 60 is 6.9282, 6.9375.

TEST_CASE("a star runs from its upper tip, clockwise, from tip to dent to tip")
{
    CHECK(drawn("star 50 50 points=3 r=16 inner=4") == "M 50 34 L 53.4375 48 L 63.875 58"
                                                       " L 50 54 L 36.125 58 L 46.5625 48 L 50 34");
    CHECK(drawn("star 50 50 points=4 r=40 inner=0") ==
          "M 50 10 L 50 50 L 90 50 L 50 50 L 50 90 L 50 50 L 10 50 L 50 50 L 50 10");
}

TEST_CASE("a star has five points and dents of half its radius unless it says otherwise")
{
    const std::string star = "M 50 10 L 61.75 33.8125 L 88.0625 37.625 L 69 56.1875 L 73.5 82.375"
                             " L 50 70 L 26.5 82.375 L 31 56.1875 L 11.9375 37.625 L 38.25 33.8125 L 50 10";
    CHECK(drawn("star 50 50 r=40") == star);
    CHECK(drawn("star 50 50 r=40 points=5 inner=20 turn=0") == star);
}

TEST_CASE("a regular polygon runs from its upper corner, clockwise")
{
    CHECK(drawn("regular 50 50 sides=4 r=40") == "M 50 10 L 90 50 L 50 90 L 10 50 L 50 10");
    CHECK(drawn("regular 50 50 sides=6 r=16") ==
          "M 50 34 L 63.875 42 L 63.875 58 L 50 66 L 36.125 58 L 36.125 42 L 50 34");
    CHECK(drawn("regular 50 50 sides=3 r=0") == "M 50 50");
}

TEST_CASE("positive turns are clockwise")
{
    CHECK(drawn("star 50 50 points=3 r=16 inner=8 turn=30") ==
          "M 58 36.125 L 58 50 L 58 63.875 L 46 56.9375 L 34 50 L 46 43.0625 L 58 36.125");
    CHECK(drawn("regular 50 50 sides=4 r=40 turn=90") == "M 90 50 L 50 90 L 10 50 L 50 10 L 90 50");
    CHECK(drawn("regular 50 50 sides=4 r=40 turn=-90") == "M 10 50 L 50 10 L 90 50 L 50 90 L 10 50");
    CHECK(drawn("regular 50 50 sides=4 r=40 turn=3600") == drawn("regular 50 50 sides=4 r=40"));
}

TEST_CASE("quarters of a turn are exact, so that halves of 1/16 px round the same way on all sides")
{
    CHECK(drawn("regular 50.03125 50.03125 sides=4 r=40") ==
          "M 50.0625 10.0625 L 90.0625 50.0625 L 50.0625 90.0625 L 10.0625 50.0625 L 50.0625 10.0625");
}

TEST_CASE("stars and regular polygons of another form are refused")
{
    CHECK(drawn("star 1 2") == "1:1 error: star needs the property \"r\" (add r=…)");
    CHECK(drawn("star 1 r=2") == "1:1 error: star needs more values (write star CX CY points=NUMBER r=RADIUS "
                                 "inner=RADIUS turn=DEGREES)");
    CHECK(drawn("star 1 2 r=3 points=2") == "1:21 error: this number is out of range (allowed: 3 to 1000)");
    CHECK(drawn("star 1 2 r=3 points=4.5") == "1:21 error: a whole number is expected here");
    CHECK(drawn("star 1 2 r=3 inner=-1") == "1:20 error: this number is out of range (allowed: 0 to 4094)");
    CHECK(drawn("star 1 2 r=3 turn=3601") ==
          "1:19 error: this number is out of range (allowed: -3600 to 3600)");
    CHECK(drawn("regular 1 2 r=3") == "1:1 error: regular needs the property \"sides\" (add sides=…)");
    CHECK(drawn("regular 1 2 r=3 sides=1001") ==
          "1:23 error: this number is out of range (allowed: 3 to 1000)");
    CHECK(drawn("regular 1 2 r=3 sides=3 inner=1") ==
          "1:25 error: regular has no property \"inner\" (allowed: sides, r, turn)");
    CHECK(drawn("star 2040 2 r=30") == "1:1 error: this star reaches more than 2047 px from the origin");
}

}
