#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// Of a skeleton with an upright bone `a`, on which `b` lies; the bones as set up are left out.
std::string posed(const std::string& poses, std::string_view properties = "")
{
    std::string text = bones_read("bone a 50 90 50 50 { bone b 50 50 70 50 }; " + poses, properties);
    for (const std::string_view as_set_up : {"a 49152 800 1440 640", "b <a tip 16384 640 0 320"})
        if (const auto at = text.find(as_set_up); at != std::string::npos)
            text.erase(at + 1, as_set_up.size() - 1);
    return text;
}

constexpr int column = 44; ///< where the poses begin

std::string at(int offset, const std::string& message)
{
    std::string text{"1:"};
    return text.append(std::to_string(column + offset)).append(1, ' ').append(message);
}

}

TEST_CASE("a pose gives the bones that it names a key")
{
    CHECK(posed("pose 0 rest; pose 10 { b turn=90 }; pose 20 { b }; pose 30 { a turn=-90 }") ==
          "a angle[0:49152 30:32768]\n"
          "b angle[0:16384 10:32768 20:16384]");
}

TEST_CASE("quantities that stay as set up have no keys")
{
    CHECK(posed("pose 0 { a turn=360; b length=20 }; pose 9 rest") == "a\nb");
    CHECK(posed("pose 0 { a turn=360 }; pose 9 rest", "turns=as-written") == "a angle[0:114688 9:49152]\nb");
}

TEST_CASE("a pose moves origins in the directions of the canvas as set up, and sets lengths")
{
    CHECK(posed("pose 0 rest; pose 10 { a x=1 y=-2; b x=3 length=0 }; pose 20 { b y=4 }") ==
          "a x[0:800 10:816] y[0:1440 10:1408]\n"
          "b x[0:640 10:640 20:576] y[0:0 10:48 20:0] length[0:320 10:0 20:320]");
}

TEST_CASE("poses have names, before or behind where they are used")
{
    CHECK(posed("pose 0 up; pose up { b turn=-45 }; pose 5 down { b turn=45 }; pose 9 up; pose 12 down") ==
          "a\nb angle[0:8192 5:24576 9:8192 12:24576]");
    CHECK(posed("pose 0 rest; pose up { b turn=1 }") ==
          "a\nb\n" + at(13, "warning: the pose \"up\" is not used (use it: pose TIME up, or remove it)"));
}

TEST_CASE("turns take the shortest way unless the skeleton says otherwise")
{
    CHECK(posed("pose 0 { b turn=-100 }; pose 1 { b turn=1000 }") == "a\nb angle[0:63716 1:1820]");
    CHECK(posed("pose 0 { b turn=-100 }; pose 1 { b turn=1000 }", "turns=as-written") ==
          "a\nb angle[0:-1820 1:198428]");
}

TEST_CASE("half a turn exactly is warned of, since it goes counter-clockwise")
{
    CHECK(posed("pose 0 { b }; pose 10 { b turn=180 }").find("exactly half a turn") != std::string::npos);
    CHECK(posed("pose 0 { b }; pose 10 { b turn=179 }").find("half a turn") == std::string::npos);
    CHECK(posed("pose 0 { b }; pose 10 { b turn=180 }", "turns=as-written").find("half a turn") ==
          std::string::npos);
}

TEST_CASE("the laws of a pose govern the ways of its bones to their next poses")
{
    CHECK(
        posed("pose 0 law=accelerate { a turn=1; b turn=1 x=1 }; pose 5 law=decelerate law-y=hold { b x=2 }\n"
              "pose 9 rest") ==
        "a angle[0:49334(accelerate,accelerate) 9:49152]\n"
        "b angle[0:16566(accelerate,accelerate) 5:16384(decelerate,decelerate) 9:16384] "
        "y[0:16(accelerate,accelerate) 5:32(decelerate,hold) 9:0]");
    CHECK(posed("pose 0 law-y=hold { a turn=1 }; pose 5 law=hold { b turn=1 }; pose 7 { a }") ==
          "a angle[0:49334 7:49152]\nb angle[5:16566]\n" +
              at(39, "warning: this law governs nothing (remove it, or let a later pose set one of these "
                     "bones)"));
}

TEST_CASE("poses stand in the order of their times")
{
    CHECK(posed("pose 5 rest; pose 5 rest; pose 4 rest") ==
          at(13, "error: there is a pose at this time already, on line 4 (times are rounded to 1/1024 frame; "
                 "choose another)\n") +
              at(26, "error: this pose is earlier than the one before it, on line 4 (put the poses in the "
                     "order of their times)"));
    CHECK(posed("pose -1 rest") == at(5, "error: a time cannot be negative"));
    CHECK(posed("pose #true rest") == at(5, "error: a number is expected here"));
}

TEST_CASE("the last pose gives the scene its length, and late ones are not seen")
{
    const auto text = read_on_canvas("bones s { bone a 0 0 9 0; pose 0 rest; pose 40 rest }\n"
                                     "object o fill=red skin=s { empty }");
    REQUIRE(text.scene);
    CHECK(text.scene->length == Time::frame(40));
    CHECK(read("kfast 1\ncanvas 9 9 frames=5\nbones s { bone a 0 0 9 0; pose 5 rest; pose 9 rest }\n"
               "object o fill=red skin=s { empty }")
              .findings == "3:40 warning: the scene ends before anything of this pose is seen (make the "
                           "scene longer with frames=… or remove the pose)");
}

TEST_CASE("a pose names bones of its skeleton, each once")
{
    CHECK(posed("pose 0 { bb turn=1 }") == at(9, "error: unknown bone \"bb\" (did you mean \"b\"?)"));
    CHECK(posed("pose 0 { b turn=1; a; b x=1 }") == at(22, "error: this pose sets \"b\" already, on line 4"));
    CHECK(posed("pose 0 { b 3 }") == at(11,
                                        "error: this value is too many for b (write BONE turn=DEGREES x=X "
                                        "y=Y length=LENGTH)"));
    CHECK(posed("pose 0 { b angle=3 }").starts_with(at(11, "error: b has no property \"angle\"")));
    CHECK(posed("pose 0 { b turn=6000 }") ==
          at(16, "error: this number is out of range (allowed: -5400 to 5400)"));
    CHECK(posed("pose 0 { b length=-1 }") ==
          at(18, "error: this number is out of range (allowed: 0 to 4095)"));
    CHECK(posed("pose 0 { b y=-2040 }") ==
          at(9, "error: this bone begins more than 2047 px from its parent's origin"));
}

TEST_CASE("a pose that sets no bones is none")
{
    CHECK(posed("pose 0") == at(0,
                                "error: this pose sets no bones (add { BONE turn=DEGREES }, or the name of "
                                "a pose such as rest)"));
    CHECK(posed("pose 0 {}").starts_with(at(0, "error: this pose sets no bones")));
    CHECK(posed("pose up") == at(0, "error: this pose has neither a time nor bones (write pose TIME up, or "
                                    "add { BONE turn=DEGREES })"));
}

TEST_CASE("names of poses are known, and given once")
{
    CHECK(posed("pose 0 up { b turn=1 }; pose 5 upp") ==
          at(31, "error: unknown pose \"upp\" (did you mean \"up\"?)"));
    CHECK(posed("pose 0 up { b turn=1 }; pose 5 up { a turn=1 }") ==
          at(24, "error: there is a pose \"up\" already, on line 4"));
    CHECK(posed("pose 0 rest { b turn=1 }") ==
          at(7, "error: \"rest\" is the pose of all bones as they are set up (choose another name)"));
    CHECK(posed("pose up law=hold { b turn=1 }; pose 0 up")
              .starts_with(at(8, "error: pose has no property \"law\"")));
    CHECK(posed("pose up 3 { b turn=1 }") ==
          at(8, "error: this value is too many for pose (write pose NAME { BONE turn=DEGREES })"));
}
TEST_CASE("poses set no more bones than there is memory for, however often names repeat them")
{
    std::string text;
    for (int i = 0; i < 255; ++i)
        text += "bone b" + std::to_string(i) + " 0 0 9 0; ";
    constexpr int one_too_many = (1 << 19) / 255 + 1;
    for (int i = 0; i < one_too_many; ++i)
        text += "pose " + std::to_string(i) + " rest; ";
    const std::string findings = bones_read(text);
    CHECK(findings.ends_with(" error: the poses of this scene set more than 524288 bones (let poses set only "
                             "the bones that they move)"));
}

}
