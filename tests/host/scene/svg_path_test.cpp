#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <string>

namespace kfast::test {
namespace {

const std::string number_hint = " (M, L and T take x y; H x; V y; S and Q x y x y; C x y x y x y)";

}

TEST_CASE("lines, absolute and relative")
{
    CHECK(path_drawn("M 10 20 L 30 40") == "M 10 20 L 30 40");
    CHECK(path_drawn("m 10 20 l 30 40 l -5 -5") == "M 10 20 L 40 60 L 35 55");
    CHECK(path_drawn("M 10 20 H 30 V 5") == "M 10 20 L 30 20 L 30 5");
    CHECK(path_drawn("M 10 20 h 30 v 5") == "M 10 20 L 40 20 L 40 25");
}

TEST_CASE("repeated arguments repeat the command; after a move they are lines")
{
    CHECK(path_drawn("M 1 2 3 4 5 6") == "M 1 2 L 3 4 L 5 6");
    CHECK(path_drawn("m 1 2 3 4 5 6") == "M 1 2 L 4 6 L 9 12");
    CHECK(path_drawn("M 1 2 L 3 4 5 6 7 8") == "M 1 2 L 3 4 L 5 6 L 7 8");
    CHECK(path_drawn("M 1 2 H 3 4 v 5 6") == "M 1 2 L 3 2 L 4 2 L 4 7 L 4 13");
}

TEST_CASE("numbers need no separators where they cannot be mistaken")
{
    CHECK(path_drawn("M.5.5-3e1.25L1e1,+2E-0") == "M 0.5 0.5 L -30 0.25 L 10 2");
    CHECK(path_drawn("M1-2L3-4") == "M 1 -2 L 3 -4");
    CHECK(path_drawn("\tM1,2 ,3 , 4 ") == "M 1 2 L 3 4");
    CHECK(path_drawn("M1. 2.L3.5.5") == "M 1 2 L 3.5 0.5");
    CHECK(path_drawn("M0 0L1 1z") == "M 0 0 L 1 1 L 0 0");
}

TEST_CASE("cubics, absolute, relative and smooth")
{
    CHECK(path_drawn("M 10 10 C 20 10 30 20 30 30") == "M 10 10 C 20 10 30 20 30 30");
    CHECK(path_drawn("M 10 10 c 10 0 20 10 20 20 1 2 3 4 5 6") ==
          "M 10 10 C 20 10 30 20 30 30 C 31 32 33 34 35 36");
    CHECK(path_drawn("M 10 10 C 20 10 30 20 30 30 S 50 60 70 80") ==
          "M 10 10 C 20 10 30 20 30 30 C 30 40 50 60 70 80");
    CHECK(path_drawn("M 10 10 c 10 0 20 10 20 20 s 1 2 3 4 1 2 3 4") ==
          "M 10 10 C 20 10 30 20 30 30 C 30 40 31 32 33 34 C 35 36 34 36 36 38");
}

TEST_CASE("a smooth cubic after anything else starts from its own point")
{
    CHECK(path_drawn("M 10 10 S 20 30 40 50") == "M 10 10 C 10 10 20 30 40 50");
    CHECK(path_drawn("M 10 10 Q 16 10 16 16 S 20 30 40 50") ==
          "M 10 10 C 14 10 16 12 16 16 C 16 16 20 30 40 50");
}

TEST_CASE("quadratics become the same cubics")
{
    CHECK(path_drawn("M 0 0 Q 30 0 30 30") == "M 0 0 C 20 0 30 10 30 30");
    CHECK(path_drawn("M 3 3 q 30 0 30 30") == "M 3 3 C 23 3 33 13 33 33");
    CHECK(path_drawn("M 0 0 Q 10 0 10 10") == "M 0 0 C 6.6875 0 10 3.3125 10 10"); // 6.667, 3.333
}

TEST_CASE("smooth quadratics mirror the control point, again and again")
{
    CHECK(path_drawn("M 0 0 Q 15 30 30 0 T 60 0 90 0") ==
          "M 0 0 C 10 20 20 20 30 0 C 40 -20 50 -20 60 0 C 70 20 80 20 90 0");
    CHECK(path_drawn("M 0 0 q 15 30 30 0 t 30 0") == "M 0 0 C 10 20 20 20 30 0 C 40 -20 50 -20 60 0");
    CHECK(path_drawn("M 0 0 T 30 0") == "M 0 0 C 0 0 10 0 30 0");
    CHECK(path_drawn("M 0 0 C 1 2 3 4 6 6 T 36 6") == "M 0 0 C 1 2 3 4 6 6 C 6 6 16 6 36 6");
}

TEST_CASE("closing adds the line that is missing, and the next stroke starts there")
{
    CHECK(path_drawn("M 1 1 L 5 1 L 5 5 Z") == "M 1 1 L 5 1 L 5 5 L 1 1");
    CHECK(path_drawn("M 1 1 L 5 1 L 1 1 Z") == "M 1 1 L 5 1 L 1 1");
    CHECK(path_drawn("M 1 1 L 5 1 L 5 5 L 1.01 0.99 z") == "M 1 1 L 5 1 L 5 5 L 1 1");
    CHECK(path_drawn("M 1 1 h 5 v 5 z l 2 2") == "M 1 1 L 6 1 L 6 6 L 1 1 M 1 1 L 3 3");
    CHECK(path_drawn("M 1 1 h 5 v 5 z m 2 2 h 1") == "M 1 1 L 6 1 L 6 6 L 1 1 M 3 3 L 4 3");
    CHECK(path_drawn("M 1 1 H 5 Z Z z") == "M 1 1 L 5 1 L 1 1");
}

TEST_CASE("several moves are several strokes")
{
    CHECK(path_drawn("M 1 1 L 2 2 M 5 5 L 6 6") == "M 1 1 L 2 2 M 5 5 L 6 6");
    CHECK(path_drawn("M 1 1 L 2 2 m 3 3 l 1 1") == "M 1 1 L 2 2 M 5 5 L 6 6");
}

TEST_CASE("a dot is a closed move or a segment of no length")
{
    CHECK(path_drawn("M 5 5 Z") == "M 5 5");
    CHECK(path_drawn("M 5 5 L 5 5") == "M 5 5");
    CHECK(path_drawn("M 5 5 h 0.01 M 7 7 c 0 0 0 0 0 0") == "M 5 5 M 7 7");
    CHECK(path_drawn("M 5 5 A 3 3 0 0 0 5 5") == "M 5 5");
}

TEST_CASE("a move that nothing is drawn from is dropped with a warning, once a path")
{
    constexpr auto warning = " warning: nothing is drawn from here "
                             "(for a dot write \"M x y Z\", else remove the move)";
    CHECK(path_drawn("M 5 5") == std::string{"1:1"} + warning);
    CHECK(path_drawn("M 1 1 L 2 2 M 5 5 m 1 1") == std::string{"M 1 1 L 2 2\n1:13"} + warning);
    CHECK(path_drawn("") == "1:0 warning: this path draws nothing");
    CHECK(path_drawn("  ") == "1:0 warning: this path draws nothing");
}

TEST_CASE("a curve that returns to its start is kept")
{
    CHECK(path_drawn("M 5 5 C 9 5 5 9 5 5") == "M 5 5 C 9 5 5 9 5 5");
}

TEST_CASE("arc flags need no separators")
{
    const std::string spaced = path_drawn("M 10 0 A 10 10 0 0 1 20 10");
    CHECK(spaced == "M 10 0 C 15.5 0 20 4.5 20 10"); // 5.5228 rounds to 5.5, 4.4772 to 4.5
    CHECK(path_drawn("M10 0A10,10,0,0,1,20,10") == spaced);
    CHECK(path_drawn("M10 0A10 10 0 0120 10") == spaced);
    CHECK(path_drawn("M10 0a10 10 0 01.1e2 10") == spaced);
    CHECK(path_drawn("M10 0a10 10 0 0110 10") == spaced);
    CHECK(path_drawn("M10 0a10 10 0 0 1 10 10 10 10 0 0 1-10 10") ==
          "M 10 0 C 15.5 0 20 4.5 20 10 C 20 15.5 15.5 20 10 20");
}

TEST_CASE("errors point into the text of the path")
{
    CHECK(path_drawn("L 1 2") == "1:1 error: a path must begin with a move (begin with \"M x y\")");
    CHECK(path_drawn("7 1 2") == "1:1 error: a path command is expected here "
                                 "(allowed: M L H V C S Q T A Z and their lower case)");
    CHECK(path_drawn("M 1 2 X 3 4") == "1:7 error: a path command is expected here "
                                       "(allowed: M L H V C S Q T A Z and their lower case)");
    CHECK(path_drawn("M 1 2 Z 3 4") == "1:9 error: a path command is expected here "
                                       "(allowed: M L H V C S Q T A Z and their lower case)");
    CHECK(path_drawn("M 1 2 , L 3 4") == "1:9 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L 3") == "1:10 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L 3,,4") == "1:11 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L 3 4 5 H") == "1:15 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L - 4") == "1:9 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L . 4") == "1:9 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L 1e 4") == "1:10 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L nan inf") == "1:9 error: a number is expected here" + number_hint);
    CHECK(path_drawn("M 1 2 L 1e999 4") == "1:9 error: this number is out of range");
    CHECK(path_drawn("M 1 2 A 1 1 0 2 0 9 9") ==
          "1:15 error: a flag is expected here "
          "(an arc is A rx ry angle large sweep x y; large and sweep are 0 or 1)");
    CHECK(path_drawn("M 1 2 L 3 4 \xC3\xA9") == "1:13 error: a path command is expected here "
                                                "(allowed: M L H V C S Q T A Z and their lower case)");
}

TEST_CASE("points too far out are refused where they are")
{
    constexpr auto point = " error: this point lies more than 2047 px from the origin";
    constexpr auto curve = " error: this curve reaches more than 2047 px from the origin";
    CHECK(path_drawn("M 2047 -2047 L 0 0") == "M 2047 -2047 L 0 0");
    CHECK(path_drawn("M 1 2048 L 0 0") == std::string{"1:5"} + point);
    CHECK(path_drawn("M 1 1 L 2047 0 l 1 0") == std::string{"1:18"} + point);
    CHECK(path_drawn("M 1 1 C 2 2 3000 3 4 4") == std::string{"1:13"} + point);
    CHECK(path_drawn("M 0 0 C 0 0 -1100 0 0 0 S 1 1 2 2 C 2 2 1 -2000 1 1 S 5 5 6 6") ==
          std::string{"M 0 0 C 0 0 -1100 0 0 0 C 1100 0 1 1 2 2 C 2 2 1 -2000 1 1 C 1 2002 5 5 6 6"});
    CHECK(path_drawn("M 0 0 C 0 0 0 -2000 0 100 S 1 1 2 2") == std::string{"1:27"} + curve);
    CHECK(path_drawn("M 0 2040 A 30 30 0 0 0 40 2040") == std::string{"1:10"} + curve);
}

TEST_CASE("in a text whose bytes are not those of the source, words tell the place")
{
    CHECK(drawn("path \"M 1\\u{20}2 X\"") ==
          "1:6 error: a path command is expected here (line 1, column 7 of the path) "
          "(allowed: M L H V C S Q T A Z and their lower case)");
    CHECK(drawn("path \"\"\"\n  M 1 2\n  L 3\n  \"\"\"") ==
          "1:6 error: a number is expected here (line 2, column 4 of the path)" + number_hint);
    CHECK(drawn("path \"\"\"\n  M 1 2\n  L 3 4\n  \"\"\"") == "M 1 2 L 3 4");
}

TEST_CASE("what was drawn before an error is no scene")
{
    CHECK(!read_on_canvas("object o fill=red { path \"M 1 1 L 2 2 ?\" }").scene);
}

}
