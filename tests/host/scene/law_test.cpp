#include "host/scene/values/law_reader.hpp"

#include "core/time/spring_law.hpp"
#include "host/words/spring_words.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// Of a key whose law is `value`, as it is written in the scene. Column 11 is its first character.
SceneText key_with(const std::string& value)
{
    return read_on_canvas("object o fill=red {\nkey 0 law=" + value + " { empty }\nkey 9 { empty }\n}");
}

VelocityLaw law(const std::string& value)
{
    const auto [scene, findings] = key_with(value);
    CHECK(findings == "");
    REQUIRE(scene);
    return key_at(*scene).laws.x;
}

/// The same for the text within quotes: column 12 is its first character.
std::string findings(const std::string& text) { return key_with("\"" + text + "\"").findings; }

}

TEST_CASE("words are laws, in quotes or not")
{
    CHECK(law("accelerate") == VelocityLaw::accelerate);
    CHECK(law("\"accelerate\"") == VelocityLaw::accelerate);
    CHECK(law("\" hold \"") == VelocityLaw::hold);
}

TEST_CASE("the words of CSS are the curves of CSS")
{
    CHECK(law("ease") == law("\"bezier(0.25, 0.1, 0.25, 1)\""));
    CHECK(law("ease-in") == law("\"bezier(0.42, 0, 1, 1)\""));
    CHECK(law("ease-out") == law("\"bezier(0, 0, 0.58, 1)\""));
    CHECK(law("ease-in-out") == law("\"bezier(0.42, 0, 0.58, 1)\""));
    CHECK(law("ease") == VelocityLaw::bezier(2048, 819, 2048, 8192));
}

TEST_CASE("numbers stand in parentheses, rounded to 1/8192, with white space anywhere around them")
{
    CHECK(law("\"steps(4)\"") == VelocityLaw::in_steps(4));
    CHECK(law("\"steps(1)\"") == VelocityLaw::in_steps(1));
    CHECK(law("\"steps( 65535 )\"") == VelocityLaw::in_steps(65535));
    CHECK(law("\"bezier(0,-2,1,3)\"") == VelocityLaw::bezier(0, -16384, 8192, 24576));
    CHECK(law("\"bezier(1,3,0,-2)\"") == VelocityLaw::bezier(8192, 24576, 0, -16384));
    CHECK(law("\" bezier ( .5 , -.5 , 5e-1,+1.5 ) \"") == VelocityLaw::bezier(4096, -4096, 4096, 12288));
    CHECK(law("\"bezier(0.00006104,-0.00006104,0.00006,-0.00006)\"") == VelocityLaw::bezier(1, -1, 0, 0));
}

TEST_CASE("springs, bounces and the like stand alone, or with their numbers")
{
    CHECK(law("bounce") == bounce_law(3));
    CHECK(law("\"bounce-in(8)\"") == bounce_law(8, SpringEnd::earlier));
    CHECK(law("\" bounce-in-out ( 1 ) \"") == bounce_law(1, SpringEnd::both));
    CHECK(law("spring") == mass_on_spring(100, 10));
    CHECK(law("\"spring(170, 26)\"") == mass_on_spring(170, 26));
    CHECK(law("elastic") == elastic_law(0.3, SpringEnd::next));
    CHECK(law("\"elastic-in(0.5)\"") == elastic_law(0.5, SpringEnd::earlier));
    CHECK(law("elastic-in-out") == elastic_law(0.45, SpringEnd::both));
    CHECK(law("back") == law("\"back(1.70158)\""));
    CHECK(law("\"back(3)\"") == law("\"bezier(0.333333,2,0.666667,1)\""));
    CHECK(law("\"back-in(6)\"") == law("\"bezier(0.333333,0,0.666667,-2)\""));
}

TEST_CASE("a spring that does not swing is refused with what to write instead")
{
    CHECK(findings("spring(100,20)") == "4:12 error: a spring of stiffness 100 does not swing with a damping "
                                        "of 20 (take a damping of at most "
                                        "19.9, or the law \"decelerate\")");
    CHECK(law("\"spring(100,19.9)\"") == mass_on_spring(100, 19.9));
    CHECK(findings("spring(9,4)") == "4:19 error: stiffness is out of range (allowed: 10 to 10000)");
    CHECK(findings("spring(10,3)") == "4:22 error: damping is out of range (allowed: 4 to 80)");
    CHECK(findings("spring(10)") ==
          "4:21 error: spring takes 2 numbers (write \"spring(stiffness,damping)\")");
    CHECK(findings("bounce(9)") == "4:19 error: n is out of range (allowed: 1 to 8)");
    CHECK(findings("bounce 3") == "4:19 error: this is too much for a law (write \"bounce(n)\")");
}

TEST_CASE("the names of CSS and of Penner's easing functions are understood, as they are usually written")
{
    CHECK(law("linear") == VelocityLaw::constant);
    CHECK(law("easeInOut") == law("ease-in-out"));
    CHECK(law("ease_out") == law("ease-out"));
    CHECK(law("step-end") == VelocityLaw::hold);
    CHECK(law("\"cubic-bezier(0.25, 0.1, 0.25, 1)\"") == law("ease"));
    CHECK(law("\"steps(4, jump-end)\"") == VelocityLaw::in_steps(4));
    CHECK(law("\"steps(4,end)\"") == VelocityLaw::in_steps(4));
    CHECK(law("easeInOutSine") == VelocityLaw::accelerate_decelerate);
    CHECK(law("easeOutBounce") == law("bounce"));
    CHECK(law("ease-in-elastic") == law("elastic-in"));
    CHECK(law("\"easeOutBack(2)\"") == law("\"back(2)\""));
    CHECK(law("ease-in-quad") == law("\"bezier(0.33333,0,0.66667,0.33333)\""));
}

TEST_CASE("steps that jump at their beginning are not there, and what to write is said")
{
    CHECK(
        findings("steps(4, jump-start)") ==
        "4:21 error: each step jumps at its end (write \"steps(n)\", and put this key and the next one step "
        "earlier)");
    CHECK(findings("steps(4,jump-none)") == "4:20 error: each step jumps at its end (write \"steps(n)\")");
    CHECK(findings("step-start") ==
          "4:12 error: unknown law \"step-start\" (there are no jumps at the beginning: "
          "docs/scene-language.md#not-there has what to write instead)");
    CHECK(findings("easeInQuad(2)") == "4:22 error: this is too much for a law (write \"easeInQuad\")");
}

TEST_CASE("an unknown law is reported with the nearest one")
{
    CHECK(findings("wander") ==
          "4:12 error: unknown law \"wander\" (allowed: constant, accelerate, decelerate, "
          "accelerate-decelerate, hold, ease, ease-in, ease-out, ease-in-out, steps, bezier, back, back-in, "
          "back-in-out, spring, elastic, elastic-in, elastic-in-out, bounce, bounce-in, bounce-in-out)");
    CHECK(findings(" easein") == "4:13 error: unknown law \"easein\" (did you mean \"ease-in\"?)");
    CHECK(findings("bezir(0,0,1,1)") == "4:12 error: unknown law \"bezir\" (did you mean \"bezier\"?)");
    CHECK(findings("(4)").starts_with("4:12 error: unknown law \"\" (allowed: "));
    CHECK(findings("").starts_with("4:12 error: unknown law \"\" (allowed: "));
    CHECK(key_with("4").findings == "4:11 error: a word or a text in quotes is expected here");
}

TEST_CASE("a wrong count of numbers is reported")
{
    const std::string steps = " error: steps takes one number (write \"steps(n)\")";
    const std::string bezier = " error: bezier takes 4 numbers (write \"bezier(x1,y1,x2,y2)\")";
    CHECK(key_with("steps").findings == "4:11" + steps);
    CHECK(findings("steps 4") == "4:12" + steps);
    CHECK(findings("steps()") == "4:18" + steps);
    CHECK(findings("steps(4,end,5)") == "4:23 error: steps takes one number (write \"steps(n)\")");
    CHECK(findings("bezier") == "4:12" + bezier);
    CHECK(findings("bezier( )") == "4:20" + bezier);
    CHECK(findings("bezier(0,0,1)") == "4:24" + bezier);
    CHECK(findings("bezier(0,0,1,)") == "4:25" + bezier);
    CHECK(findings("bezier(0,0,1,1,1)") == "4:26" + bezier);
}

TEST_CASE("numbers out of their ranges are reported, each by its name")
{
    CHECK(findings("bezier(-0.01,0,1,1)") == "4:19 error: x1 is out of range (allowed: 0 to 1)");
    CHECK(findings("bezier(0,3.1,1,1)") == "4:21 error: y1 is out of range (allowed: -2 to 3)");
    CHECK(findings("bezier(0,0,1.5,1)") == "4:23 error: x2 is out of range (allowed: 0 to 1)");
    CHECK(findings("bezier(0,0,1, -2.001)") == "4:26 error: y2 is out of range (allowed: -2 to 3)");
    CHECK(findings("bezier(0,1e999,1,1)") == "4:21 error: y1 is out of range (allowed: -2 to 3)");
    CHECK(findings("steps(0)") == "4:18 error: n is out of range (allowed: 1 to 65535)");
    CHECK(findings("steps(65536)") == "4:18 error: n is out of range (allowed: 1 to 65535)");
    CHECK(findings("steps(2.5)") == "4:18 error: n must be a whole number (allowed: 1 to 65535)");
}

TEST_CASE("what is no number, or stands where nothing may, is reported")
{
    const std::string hint = " (write \"bezier(x1,y1,x2,y2)\")";
    CHECK(findings("bezier(a,0,1,1)") == "4:19 error: a number is expected here" + hint);
    CHECK(findings("bezier(0,,1,1)") == "4:21 error: a number is expected here" + hint);
    CHECK(findings("bezier(0 0 1 1)") == "4:21 error: \",\" is expected here" + hint);
    CHECK(findings("bezier(0,0,1,1") == "4:26 error: \")\" is expected here" + hint);
    CHECK(findings("bezier(0,0,1,1) x y") == "4:28 error: this is too much for a law" + hint);
    CHECK(findings("hold(3)") == "4:16 error: this is too much for a law (write \"hold\")");
    CHECK(findings("hold hold") == "4:17 error: this is too much for a law (write \"hold\")");
}

TEST_CASE("where the place inside the text is not known in the source, it is told in words")
{
    CHECK(key_with("\"steps\\u{28}0)\"").findings ==
          "4:11 error: n is out of range (line 1, column 7 of the law) (allowed: 1 to 65535)");
}

}
