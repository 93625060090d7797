#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

SceneText canvas(const std::string& rest) { return read("kfast 1\ncanvas " + rest); }

}

TEST_CASE("a canvas alone is a scene of one frame with the defaults")
{
    const auto [scene, findings] = canvas("240 120");
    REQUIRE(scene);
    CHECK(findings == "");
    CHECK(scene->canvas == Size{240, 120});
    CHECK(scene->frame_rate == 30'000);
    CHECK(scene->length == Time::frame(1));
    CHECK(scene->loop == Loop::repeat);
    CHECK(scene->palette == std::vector{Colour{0, 0, 0}});
    CHECK(scene->items.empty());
}

TEST_CASE("every property of a canvas is taken over")
{
    const auto [scene, findings] =
        canvas("1 2047 frames=(s)2.5 loop=ping-pong background=\"#102030\" fps=12.3456");
    REQUIRE(scene);
    CHECK(scene->canvas == Size{1, 2047});
    CHECK(scene->frame_rate == 12'346);
    CHECK(scene->loop == Loop::ping_pong);
    CHECK(scene->length.ticks == 31'606); // 2.5 s * 12.346 fps * 1024 = 31605.76
    CHECK(scene->palette == std::vector{Colour{0x10, 0x20, 0x30}});
    CHECK(canvas("9 9 loop=once").scene->loop == Loop::once);
    CHECK(canvas("9 9 loop=repeat").scene->loop == Loop::repeat);
}

TEST_CASE("a frame rate is rounded once to 1/1000, halves up")
{
    CHECK(canvas("9 9 fps=29.97").scene->frame_rate == 29'970);
    CHECK(canvas("9 9 fps=12.0625").scene->frame_rate == 12'063);
    CHECK(canvas("9 9 fps=1").scene->frame_rate == 1'000);
    CHECK(canvas("9 9 fps=1000").scene->frame_rate == 1'000'000);
}

TEST_CASE("a canvas out of range is refused where it is")
{
    CHECK(canvas("0 9").findings == "2:8 error: this number is out of range (allowed: 1 to 2047)");
    CHECK(canvas("9 2048").findings == "2:10 error: this number is out of range (allowed: 1 to 2047)");
    CHECK(canvas("9.5 9").findings == "2:8 error: a whole number is expected here");
    CHECK(canvas("wide 9").findings == "2:8 error: a number is expected here");
    CHECK(canvas("\"9\" 9").findings == "2:8 error: a number is expected here (write 9 without quotes)");
    CHECK(canvas("9 \u22129").findings ==
          "2:10 error: a number is expected here (write -9, with the minus of the keyboard)");
    CHECK(canvas("\"\" 9").findings == "2:8 error: a number is expected here");
    CHECK(canvas("9 9 background=0xff0000").findings ==
          "2:23 error: a colour is expected here (write its name or \"#rrggbb\")");
    CHECK(canvas("9 9 background=salmonella")
              .findings.ends_with("aqua, another colour of CSS, or \"#rrggbb\")"));
    CHECK(canvas("#nan 9").findings == "2:8 error: this number is out of range (allowed: 1 to 2047)");
    CHECK(canvas("9 9 fps=0.5").findings == "2:16 error: this number is out of range (allowed: 1 to 1000)");
    CHECK(canvas("9 9 fps=#inf").findings == "2:16 error: this number is out of range (allowed: 1 to 1000)");
    CHECK(canvas("9 9 frames=0.99").findings == "2:19 error: a scene cannot be shorter than one frame");
    CHECK(canvas("9 9 frames=1000001").findings ==
          "2:19 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(canvas("9 9 frames=1000000").scene->length == Time::frame(1'000'000));
}

TEST_CASE("a canvas of another form is refused")
{
    CHECK(canvas("9").findings == "2:1 error: canvas needs more values (write canvas WIDTH HEIGHT fps=30)");
    CHECK(canvas("9 9 9").findings ==
          "2:12 error: this value is too many for canvas (write canvas WIDTH HEIGHT fps=30)");
    CHECK(canvas("9 9 { x }").findings ==
          "2:14 error: canvas takes no nodes inside (write canvas WIDTH HEIGHT fps=30)");
    CHECK(canvas("(u8)9 9").findings == "2:8 error: this value takes no type or unit (leave out (u8))");
    CHECK(read("kfast 1\n(x)canvas 9 9").findings ==
          "2:4 error: a node takes no type here (write canvas WIDTH HEIGHT fps=30)");
    CHECK(canvas("9 9 fsp=30").findings ==
          "2:12 error: canvas has no property \"fsp\" (did you mean \"fps\"?)");
    CHECK(canvas("9 9 loop=pingpong").findings ==
          "2:17 error: unknown value \"pingpong\" (did you mean \"ping-pong\"?)");
    CHECK(canvas("9 9 loop=forever").findings ==
          "2:17 error: unknown value \"forever\" (KFAST calls it \"repeat\")");
    CHECK(canvas("9 9 loop=3").findings == "2:17 error: a word or a text in quotes is expected here");
    CHECK(canvas("9 9 frames=(min)3").findings ==
          "2:19 error: unknown unit \"min\" (allowed: s, ms (frames have no unit))");
    CHECK(canvas("9 9 frames=long").findings == "2:19 error: a number is expected here");
}

TEST_CASE("the background is opaque")
{
    CHECK(canvas("9 9 background=\"#123f\"").scene->palette == std::vector{Colour{0x11, 0x22, 0x33}});
    CHECK(canvas("9 9 background=\"#123e\"").findings == "2:23 error: the background cannot be transparent "
                                                         "(leave out the opacity of this colour)");
    CHECK(canvas("9 9 background=\"#12345600\"").findings ==
          "2:23 error: the background cannot be transparent "
          "(leave out the opacity of this colour)");
}

TEST_CASE("without frames= a scene ends with its last key")
{
    CHECK(
        read_on_canvas(
            "object a fill=red { key 0 { empty }; key 7.5 { empty } }\nobject b fill=red { key 3 { empty } }")
            .scene->length == Time{7'680});
    CHECK(read_on_canvas("object a fill=red { key 0 { empty }; key 0.25 { empty } }").scene->length ==
          Time::frame(1));
}

TEST_CASE("keys behind the end of the scene are warned of, once an object")
{
    const auto text =
        read("kfast 1\ncanvas 9 9 frames=10\nobject a fill=red {\n"
             "key 0 { empty }\nkey 9 { empty }\nkey 12 { empty }\nkey 14 { empty }\nkey 15 { empty }\n}");
    CHECK(text.scene);
    CHECK(text.findings == "7:1 warning: the scene ends before anything of this key is seen "
                           "(make the scene longer with frames=… or remove the key)");
    CHECK(read("kfast 1\ncanvas 9 9 frames=10\nobject a fill=red { key 0 { empty }; key 10 { empty } }")
              .findings == "");
}

}
