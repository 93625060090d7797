#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

scene::StrokeStyle stroke(const std::string& properties)
{
    const auto scene = read_on_canvas("object o stroke=white " + properties + " { key 0 { empty } }").scene;
    REQUIRE(scene);
    return *object_at(*scene).stroke;
}

}

TEST_CASE("a stroke has the defaults of SVG")
{
    CHECK(stroke("").colour == 1);
    CHECK(stroke("").width == 16);
    CHECK(stroke("").cap == Cap::butt);
    CHECK(stroke("").join == Join::miter);
}

TEST_CASE("every property of a stroke is taken over")
{
    CHECK(stroke("width=2.53").width == 40);
    CHECK(stroke("width=2.53125").width == 41);
    CHECK(stroke("width=0.0625").width == 1);
    CHECK(stroke("width=4095").width == 65'520);
    CHECK(stroke("cap=butt").cap == Cap::butt);
    CHECK(stroke("cap=round").cap == Cap::round);
    CHECK(stroke("cap=square").cap == Cap::square);
    CHECK(stroke("").miter_limit == 32);
    CHECK(stroke("miter=1").miter_limit == 8);
    CHECK(stroke("miter=2.5625").miter_limit == 21);
    CHECK(stroke("miter=31").miter_limit == 248);
    CHECK(stroke("join=miter").join == Join::miter);
    CHECK(stroke("join=round").join == Join::round);
    CHECK(stroke("join=bevel").join == Join::bevel);
}

TEST_CASE("fill and stroke are independent")
{
    const auto scene =
        read_on_canvas("object a fill=red { key 0 { empty } }\nobject b stroke=red { key 0 { empty } }\n"
                       "object \"c d\" fill=red stroke=red { key 0 { empty } }")
            .scene;
    REQUIRE(scene);
    CHECK(object_at(*scene).fill);
    CHECK(!object_at(*scene).stroke);
    CHECK(!object_at(*scene, 1).fill);
    CHECK(object_at(*scene, 1).stroke);
    CHECK(object_at(*scene, 2).fill);
    CHECK(object_at(*scene, 2).stroke);
    CHECK(scene->items[2].name == "c d");
}

TEST_CASE("an object may be filled by either rule")
{
    const auto rule = [](const std::string& properties) {
        return object_at(*read_on_canvas("object o fill=red " + properties + " { empty }").scene).fill_rule;
    };
    CHECK(rule("") == FillRule::nonzero);
    CHECK(rule("rule=nonzero") == FillRule::nonzero);
    CHECK(rule("rule=even-odd") == FillRule::even_odd);
    CHECK(read_on_canvas("object o fill=red rule=odd { empty }").findings ==
          "3:24 error: unknown value \"odd\" (allowed: nonzero, even-odd)");
    CHECK(read_on_canvas("object o stroke=red rule=even-odd { empty }").findings ==
          "3:21 warning: rule does nothing without a fill (add fill=… or remove rule)");
}

TEST_CASE("an object may say what a beam draws of it")
{
    const auto beam = [](const std::string& properties) {
        return object_at(*read_on_canvas("object o fill=red " + properties + " { empty }").scene).beam;
    };
    CHECK(beam("") == BeamStyle{});
    CHECK(beam("beam=outline") == BeamStyle{});
    CHECK(beam("beam=none").parts == BeamParts::none);
    CHECK(beam("beam=hatch") == BeamStyle{.parts = BeamParts::hatch});
    CHECK(beam("beam=both hatch=2.5 hatch-angle=-90") ==
          BeamStyle{.parts = BeamParts::both, .spacing = 40, .direction = {0xC000}});
    const auto findings = [](const std::string& properties) {
        return read_on_canvas("object o " + properties + " { empty }").findings;
    };
    CHECK(findings("fill=red beam=fill") ==
          "3:24 error: unknown value \"fill\" (allowed: outline, hatch, both, none)");
    CHECK(findings("stroke=red beam=hatch") ==
          "3:21 error: this object has no fill to hatch (add fill=COLOUR, or use beam=outline)");
    CHECK(findings("fill=red hatch=4") ==
          "3:19 warning: hatch does nothing without a hatching (add beam=hatch or remove hatch)");
    CHECK(findings("fill=red beam=hatch hatch=0.4").find("3:36 error") == 0);
}

TEST_CASE("shapes directly in an object are a still drawing at time 0")
{
    const auto [scene, findings] = read_on_canvas("object o fill=red {\n line 1 2 3 4\n line 5 6 7 8\n}");
    REQUIRE(scene);
    REQUIRE(object_at(*scene).keys.size() == 1);
    CHECK(key_at(*scene).time == Time{0});
    CHECK(text_of(key_at(*scene).drawing) == "M 1 2 L 3 4 M 5 6 L 7 8");
    CHECK(findings == "");
}

TEST_CASE("an object that would not be seen is refused")
{
    CHECK(read_on_canvas("object o { key 0 { empty } }").findings ==
          "3:1 error: this object would not be seen: it has neither fill nor stroke "
          "(add fill=COLOUR or stroke=COLOUR)");
    CHECK(read_on_canvas("object o fill=red").findings == "3:1 error: this object has no shapes and no keys "
                                                          "(add { circle 10 10 r=5 } or { key 0 { … } })");
    CHECK(read_on_canvas("object o fill=reed { key 0 { empty } }").findings ==
          "3:15 error: unknown colour \"reed\" (did you mean \"red\"?)");
}

TEST_CASE("properties of a stroke without a stroke are warned of")
{
    const auto text = read_on_canvas("object o fill=red width=3 cap=round join=bevel { key 0 { empty } }");
    CHECK(text.scene);
    CHECK(text.findings ==
          "3:19 warning: width does nothing without a stroke (add stroke=… or remove width)\n"
          "3:27 warning: cap does nothing without a stroke (add stroke=… or remove cap)\n"
          "3:37 warning: join does nothing without a stroke (add stroke=… or remove join)");
}

TEST_CASE("an object with mistakes")
{
    CHECK(read_on_canvas("object fill=red { key 0 { empty } }").findings ==
          "3:1 error: object needs more values (write object NAME fill=COLOUR { shapes or keys })");
    CHECK(read_on_canvas("object a b fill=red { key 0 { empty } }").findings ==
          "3:10 error: this value is too many for object "
          "(write object NAME fill=COLOUR { shapes or keys })");
    CHECK(read_on_canvas("object 7 fill=red { key 0 { empty } }").findings ==
          "3:8 error: a word or a text in quotes is expected here");
    CHECK(read_on_canvas("object o fil=red fill=red { key 0 { empty } }").findings ==
          "3:10 error: object has no property \"fil\" (did you mean \"fill\"?)");
    CHECK(read_on_canvas("object o fill=red wibble=1 { key 0 { empty } }").findings ==
          "3:19 error: object has no property \"wibble\" (allowed: fill, stroke, width, cap, join, miter, "
          "rule, beam, hatch, hatch-angle, skin, bone, bones, change, trim-from, trim-to, trim-offset, trim, "
          "dash, dash-offset, x, y, z, rotate, rotate-x, rotate-y, "
          "rotate-z, scale, scale-x, scale-y, opacity, order, visible, pivot-x, pivot-y, input, live)");
    CHECK(read_on_canvas("object o stroke=red cap=rund { key 0 { empty } }").findings ==
          "3:25 error: unknown value \"rund\" (did you mean \"round\"?)");
    CHECK(read_on_canvas("object o stroke=red join=arcs { key 0 { empty } }").findings ==
          "3:26 error: unknown value \"arcs\" (allowed: miter, round, bevel)");
    CHECK(read_on_canvas("object o stroke=red width=0 { key 0 { empty } }").findings ==
          "3:27 error: this number is out of range (allowed: 0.0625 to 4095)");
    CHECK(read_on_canvas("object o stroke=red miter=0.9 { key 0 { empty } }").findings ==
          "3:27 error: this number is out of range (allowed: 1 to 31)");
    CHECK(read_on_canvas("object o stroke=red miter=32 { key 0 { empty } }").findings ==
          "3:27 error: this number is out of range (allowed: 1 to 31)");
    CHECK(read_on_canvas("object o fill=red { kye 0 }").findings ==
          "3:21 error: an object has no node \"kye\" (did you mean \"key\"?)");
    CHECK(read_on_canvas("object o fill=red { disc 0 }").findings ==
          "3:21 error: an object has no node \"disc\" (KFAST calls it \"circle\")");
}

TEST_CASE("two objects of one name are refused")
{
    CHECK(read_on_canvas("object o fill=red { key 0 { empty } }\nobject o fill=red { key 0 { empty } }")
              .findings == "4:1 error: there is an object \"o\" already, on line 3");
}

TEST_CASE("keys and shapes do not mix")
{
    CHECK(read_on_canvas("object o fill=red {\n key 0 { empty }\n line 1 2 3 4\n line 1 2 3 4\n}").findings ==
          "5:2 error: an object has its drawings either in keys or without, not both "
          "(put the shapes into a key: key 0 { … })");
    CHECK(read_on_canvas("object o fill=red {\n line 1 2 3 4\n key 0 { empty }\n}").findings ==
          "5:2 error: an object has its drawings either in keys or without, not both "
          "(put the shapes into a key: key 0 { … })");
}

}
