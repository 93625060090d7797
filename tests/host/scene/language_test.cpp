#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a scene begins with the version of its language")
{
    constexpr auto missing = "1:1 error: a scene begins with the version of its language "
                             "(write \"kfast 1\" in front of everything else)";
    CHECK(read("canvas 9 9").findings == missing);
    CHECK(read("canvas 9 9\nkfast 1").findings == missing);
    CHECK(read("").findings ==
          missing + std::string{"\n1:1 error: this scene has no canvas (add \"canvas 240 240\")"});
    CHECK(read("kfast\ncanvas 9 9").findings == "1:1 error: kfast needs more values (write kfast 1)");
    CHECK(read("kfast one\ncanvas 9 9").findings == "1:7 error: a number is expected here");
    CHECK(read("kfast 1.5\ncanvas 9 9").findings == "1:7 error: a whole number is expected here");
    CHECK(read("kfast 0\ncanvas 9 9").findings ==
          "1:7 error: this number is out of range (allowed: 1 to 1000000000)");
    CHECK(read("kfast 1 x=1\ncanvas 9 9").findings ==
          "1:9 error: kfast has no property \"x\" (nothing is allowed here)");
}

TEST_CASE("of a newer version nothing else is complained about")
{
    CHECK(read("kfast 2\nhologram 9 9").findings == "1:7 error: this scene needs a newer kfast "
                                                    "(this one reads version 1 of the scene language)");
}

TEST_CASE("a canvas is needed")
{
    CHECK(read("kfast 1").findings == "1:1 error: this scene has no canvas (add \"canvas 240 240\")");
}

TEST_CASE("unknown nodes are compared with the known ones")
{
    CHECK(read_on_canvas("objekt a").findings ==
          "3:1 error: a scene has no node \"objekt\" (did you mean \"object\"?)");
    CHECK(read_on_canvas("hologram").findings == "3:1 error: a scene has no node \"hologram\" (allowed: "
                                                 "kfast, canvas, palette, symbol, object, group, "
                                                 "use, bones, clip, event, input, let)");
}

TEST_CASE("what may stand once names the line of the first")
{
    CHECK(read_on_canvas("canvas 9 9").findings == "3:1 error: there is a canvas already, on line 2");
    CHECK(read_on_canvas("kfast 1").findings == "3:1 error: there is a kfast already, on line 1");
    CHECK(read_on_canvas("palette\npalette").findings == "4:1 error: there is a palette already, on line 3");
}

TEST_CASE("nodes may come in any order after the version")
{
    const auto [scene, findings] = read("kfast 1\n"
                                        "object a fill=sky { key 0 { empty }; key (s)1 { empty } }\n"
                                        "palette { sky \"#8cf\" }\n"
                                        "canvas 9 9 background=sky fps=10");
    REQUIRE(scene);
    CHECK(scene->palette == std::vector{Colour{0x88, 0xCC, 0xFF}});
    CHECK(object_at(*scene).fill == 0);
    CHECK(scene->length == Time::frame(10));
}

TEST_CASE("one run finds errors in all parts, in the order of their places")
{
    const auto text = read("kfast 1\ncanvas 0 9\npalette { a redd  }\nobject o {\n key x { disc 1 2 }\n}");
    CHECK(!text.scene);
    CHECK(text.findings == "2:8 error: this number is out of range (allowed: 1 to 2047)\n"
                           "3:13 error: unknown colour \"redd\" (did you mean \"red\"?)\n"
                           "4:1 error: this object would not be seen: it has neither fill nor stroke "
                           "(add fill=COLOUR or stroke=COLOUR)\n"
                           "5:6 error: a number is expected here\n"
                           "5:10 error: a key has no node \"disc\" "
                           "(KFAST calls it \"circle\")");
}

TEST_CASE("a scene with syntax errors is not read as good")
{
    const auto text = read("kfast 1\ncanvas 9 9\npalette {");
    CHECK(!text.scene);
    CHECK(text.findings != "");
}

TEST_CASE("places count code points, names are shown safely")
{
    CHECK(read_on_canvas("/* äöü */ \"é\\u{1b}\"").findings ==
          "3:11 error: a scene has no node \"é<U+001B>\" (allowed: kfast, canvas, palette, "
          "symbol, object, group, use, bones, clip, event, input, let)");
}

}
