#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <string>

namespace kfast::test {
namespace {

/// Two legs that are set up upon each other, and pose as `poses` say.
std::string findings_of_legs(const std::string& object,
                             const std::string& poses = "pose 0 { l turn=9 }; pose 9 { l turn=1 }",
                             const std::string& right = "50 40 50 80")
{
    return read_on_canvas("bones s { bone hip 50 10 50 40 { bone l 50 40 50 80; bone r " + right + " }; " +
                          poses + " }\nobject o stroke=red " + object)
        .findings;
}

const std::string legs = "skin=s { line 50 20 50 30; line 50 60 50 80; line 50 70 50 80 }";
const std::string hint =
    " (let each limb be an object with its own bones=\"NAME …\", or give them weights { points FIRST LAST { "
    "BONE WEIGHT } })";

}

TEST_CASE("points that follow two bones alike which lie on each other get a warning")
{
    CHECK(findings_of_legs(legs) ==
          "4:1 warning: points 3 to 6 follow l and r alike, which lie on each other" + hint);
    CHECK(findings_of_legs("skin=s { line 50 70 50 20 }") ==
          "4:1 warning: point 1 follows l and r alike, which lie on each other" + hint);
    CHECK(findings_of_legs("skin=s { line 50 60 50 20 50 80; line 50 70 50 80 }") ==
          "4:1 warning: points 1 and 3 to 5 follow l and r alike, which lie on each other" + hint);
    CHECK(findings_of_legs(legs, "pose 0 { l turn=9 }; pose 9 { l turn=1 }", "51 41 50 70") != ""); // nearly
}

TEST_CASE("bones that lie apart, or never part, may share points")
{
    CHECK(findings_of_legs(legs, "pose 0 { l turn=9 }; pose 9 { l turn=1 }", "60 40 60 80") == "");
    CHECK(findings_of_legs(legs, "pose 0 { l turn=9 }; pose 9 { l turn=1 }", "50 40 80 70") == "");
    CHECK(findings_of_legs(legs, "pose 0 { hip turn=9 }; pose 9 { hip turn=1 }") == "");
    const auto findings_of_feet = [](const std::string& posed) {
        return read_on_canvas(
                   "bones s { bone hip 50 10 50 40 { bone l 50 40 50 60 { bone lf 50 60 50 80 }\n"
                   "bone r 50 40 50 60 { bone rf 50 60 50 80 } }\npose 0 { " +
                   posed + " turn=9 }; pose 9 { " + posed +
                   " turn=1 } }\nobject o stroke=red skin=s { line 50 20 50 30; line 50 70 50 80 }")
            .findings;
    };
    CHECK(findings_of_feet("hip") == "");
    CHECK(findings_of_feet("r") != "");
}

TEST_CASE("given weights, or one bone, are no doubt")
{
    CHECK(findings_of_legs("skin=s { line 50 60 50 80; weights { l 1 } }") == "");
    CHECK(findings_of_legs("skin=s { line 50 60 50 80; weights { l 1; r 1 } }") == "");
    CHECK(findings_of_legs("skin=s { line 50 60 50 80; weights auto }") == "");
    CHECK(findings_of_legs("skin=s bone=l { line 50 60 50 80 }") == "");
}

TEST_CASE("several pairs of bones have one warning")
{
    const std::string text =
        read_on_canvas("bones s { bone l 50 10 50 40 { bone ll 50 40 50 80 }\n"
                       "bone r 50 10 50 40 { bone rl 50 40 50 80 }\n"
                       "pose 0 { l turn=9 }; pose 9 { r turn=1; rl turn=3 } }\n"
                       "object o stroke=red skin=s { line 50 10 50 30; line 50 60 50 80 }")
            .findings;
    CHECK(text ==
          "6:1 warning: points 1 to 2 follow l and r alike, which lie on each other, and so do points of 1 "
          "other pair of bones" +
              hint);
}

}
