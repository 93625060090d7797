#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

scene::StrokeStyle stroke(const std::string& properties)
{
    const auto scene = read_on_canvas("object o stroke=white " + properties + " { key 0 }").scene;
    REQUIRE(scene);
    return *scene->objects.at(0).stroke;
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
    CHECK(stroke("join=miter").join == Join::miter);
    CHECK(stroke("join=round").join == Join::round);
    CHECK(stroke("join=bevel").join == Join::bevel);
}

TEST_CASE("fill and stroke are independent")
{
    const auto scene = read_on_canvas("object a fill=red { key 0 }\nobject b stroke=red { key 0 }\n"
                                      "object \"c d\" fill=red stroke=red { key 0 }")
                           .scene;
    REQUIRE(scene);
    CHECK(scene->objects[0].fill);
    CHECK(!scene->objects[0].stroke);
    CHECK(!scene->objects[1].fill);
    CHECK(scene->objects[1].stroke);
    CHECK(scene->objects[2].fill);
    CHECK(scene->objects[2].stroke);
    CHECK(scene->objects[2].name == "c d");
}

TEST_CASE("shapes directly in an object are a still drawing at time 0")
{
    const auto [scene, findings] = read_on_canvas("object o fill=red {\n line 1 2 3 4\n line 5 6 7 8\n}");
    REQUIRE(scene);
    REQUIRE(scene->objects[0].keys.size() == 1);
    CHECK(scene->objects[0].keys[0].time == Time{0});
    CHECK(text_of(scene->objects[0].keys[0].drawing) == "M 1 2 L 3 4 M 5 6 L 7 8");
    CHECK(findings == "");
}

TEST_CASE("an object that would not be seen is refused")
{
    CHECK(read_on_canvas("object o { key 0 }").findings ==
          "3:1 error: this object would not be seen: it has neither fill nor stroke "
          "(add fill=COLOUR or stroke=COLOUR)");
    CHECK(read_on_canvas("object o fill=red").findings == "3:1 error: this object has no shapes and no keys "
                                                          "(add { circle 10 10 r=5 } or { key 0 { … } })");
    CHECK(read_on_canvas("object o fill=reed { key 0 }").findings ==
          "3:15 error: unknown colour \"reed\" (did you mean \"red\"?)");
}

TEST_CASE("properties of a stroke without a stroke are warned of")
{
    const auto text = read_on_canvas("object o fill=red width=3 cap=round join=bevel { key 0 }");
    CHECK(text.scene);
    CHECK(text.findings ==
          "3:19 warning: width does nothing without a stroke (add stroke=… or remove width)\n"
          "3:27 warning: cap does nothing without a stroke (add stroke=… or remove cap)\n"
          "3:37 warning: join does nothing without a stroke (add stroke=… or remove join)");
}

TEST_CASE("an object with mistakes")
{
    CHECK(read_on_canvas("object fill=red { key 0 }").findings ==
          "3:1 error: object needs more values (write object NAME fill=COLOUR { shapes or keys })");
    CHECK(read_on_canvas("object a b fill=red { key 0 }").findings ==
          "3:10 error: this value is too many for object "
          "(write object NAME fill=COLOUR { shapes or keys })");
    CHECK(read_on_canvas("object 7 fill=red { key 0 }").findings ==
          "3:8 error: a word or a text in quotes is expected here");
    CHECK(read_on_canvas("object o fil=red fill=red { key 0 }").findings ==
          "3:10 error: object has no property \"fil\" (did you mean \"fill\"?)");
    CHECK(read_on_canvas("object o fill=red opacity=1 { key 0 }").findings ==
          "3:19 error: object has no property \"opacity\" (allowed: fill, stroke, width, cap, join)");
    CHECK(read_on_canvas("object o stroke=red cap=rund { key 0 }").findings ==
          "3:25 error: unknown value \"rund\" (did you mean \"round\"?)");
    CHECK(read_on_canvas("object o stroke=red join=arcs { key 0 }").findings ==
          "3:26 error: unknown value \"arcs\" (allowed: miter, round, bevel)");
    CHECK(read_on_canvas("object o stroke=red width=0 { key 0 }").findings ==
          "3:27 error: this number is out of range (allowed: 0.0625 to 4095)");
    CHECK(read_on_canvas("object o fill=red { kye 0 }").findings ==
          "3:21 error: an object has no node \"kye\" (did you mean \"key\"?)");
    CHECK(read_on_canvas("object o fill=red { disc 0 }").findings ==
          "3:21 error: an object has no node \"disc\" "
          "(allowed: key, path, circle, ellipse, rect, polygon, line)");
}

TEST_CASE("two objects of one name are refused")
{
    CHECK(read_on_canvas("object o fill=red { key 0 }\nobject o fill=red { key 0 }").findings ==
          "4:1 error: there is an object \"o\" already, on line 3");
}

TEST_CASE("keys and shapes do not mix")
{
    CHECK(read_on_canvas("object o fill=red {\n key 0\n line 1 2 3 4\n line 1 2 3 4\n}").findings ==
          "5:2 error: an object has either keys or shapes, not both "
          "(put the shapes into a key: key 0 { … })");
    CHECK(read_on_canvas("object o fill=red {\n line 1 2 3 4\n key 0\n}").findings ==
          "5:2 error: an object has either keys or shapes, not both "
          "(put the shapes into a key: key 0 { … })");
}

}
