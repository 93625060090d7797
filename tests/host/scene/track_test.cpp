#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("each property goes from a key that sets it to the next key that sets it")
{
    CHECK(items_read("object o fill=red { rect 0 0 2 2\n"
                     "key 0 x=1 y=1; key 10 x=2; key 20 y=3 opacity=0.4; key 30 x=4 }") ==
          "object o @0 x[0:16 10:32 30:64] y[0:16 20:48] opacity[0:255 20:102]");
}

TEST_CASE("what the first key leaves out, the item gives, or else its default")
{
    CHECK(items_read("object o fill=red x=5 scale=2 {\n"
                     "key 10 { rect 0 0 2 2 }; key 20 x=6 y=1 scale-y=1 visible=#false }") ==
          "object o @10 x[10:80 20:96] y[10:0 20:16] scale_x[8192] scale_y[10:8192 20:4096] "
          "pivot_x[16] pivot_y[16] visible[10:1 20:0]");
    CHECK(items_read("object o fill=red x=5 { rect 0 0 2 2; key 10 x=7; key 20 x=6 }") ==
          "object o @0 x[10:112 20:96]");
}

TEST_CASE("fill, stroke and width tween from what the object has")
{
    CHECK(items_read("object o fill=red { key 0 { empty }; key 30 fill=blue { empty } }") ==
          "object o @0,30 fill[0:1 30:2]");
    CHECK(items_read("object o stroke=red width=2 { line 0 0 1 1; key 5 width=0; key 6 stroke=lime }") ==
          "object o @0 stroke[5:1 6:2] width[5:0]");
    CHECK(
        items_read("object o stroke=red { line 0 0 1 1; key 5 fill=red; key 6 width=3; key 7 opacity=1 }") ==
        "1:43 error: this object has no fill to change (add fill=COLOUR to the object)");
    CHECK(
        items_read("object o fill=red { line 0 0 1 1; key 5 width=2; key 6 stroke=red; key 7 fill=blue }") ==
        "1:41 error: this object has no stroke to change (add stroke=COLOUR to the object)\n"
        "1:56 error: this object has no stroke to change (add stroke=COLOUR to the object)");
}

TEST_CASE("drawings go from drawing key to drawing key")
{
    const auto [scene, findings] = read_on_canvas("object o fill=red {\n"
                                                  "key 0 law=accelerate { circle 0 0 r=1 }\n"
                                                  "key 5 law=decelerate x=3\n"
                                                  "key 10 { empty }\nkey 15 x=4\n}");
    REQUIRE(scene);
    CHECK(findings == "");
    REQUIRE(object_at(*scene).keys.size() == 2);
    CHECK(key_at(*scene).laws == LawPair{VelocityLaw::accelerate, VelocityLaw::accelerate});
    CHECK(key_at(*scene, 1).time == Time::frame(10));
    CHECK(key_at(*scene, 1).laws == LawPair{});
}

TEST_CASE("each way has the laws of the key that it leaves; those of an axis govern what has one")
{
    CHECK(
        items_read("object o stroke=red {\nkey 0 law=accelerate law-y=hold { rect 0 0 2 2 }\n"
                   "key 9 x=1 y=1 rotate=90 scale=2 opacity=0 order=1 visible=#false stroke=blue width=2 {\n"
                   "rect 0 0 2 2 }\n}") ==
        "object o @0,9 x[0:0(accelerate,hold) 9:16] y[0:0(accelerate,hold) 9:16] "
        "rotation[0:0(accelerate,accelerate) 9:16384] "
        "scale_x[0:4096(accelerate,hold) 9:8192] "
        "scale_y[0:4096(accelerate,hold) 9:8192] pivot_x[16] pivot_y[16] "
        "opacity[0:255(accelerate,accelerate) 9:0] order[0:0 9:1] "
        "visible[0:1 9:0] stroke[0:1(accelerate,accelerate) 9:2] "
        "width[0:16(accelerate,accelerate) 9:32]");
}

TEST_CASE("a law that governs nothing is warned of")
{
    const auto group = [](const std::string& keys) {
        return items_read("group { object o fill=red { rect 0 0 2 2 }\n" + keys + "\n}");
    };
    const std::string hint = " (remove it, or let a later key set what this one sets)";
    CHECK(group("key 0 law=hold; key 9 opacity=0")
              .ends_with("2:1 error: this key sets nothing (add a property such as x=10)"));
    CHECK(group("key 0 x=0 law=hold; key 9 opacity=0")
              .ends_with("opacity[0:255(hold,hold) 9:0]\n  object o @0"));
    CHECK(group("key 0 x=0; key 1 x=1 law=hold; key 9 opacity=0")
              .ends_with("2:22 warning: this law governs nothing" + hint));
    CHECK(group("key 0 order=0 law=hold; key 9 order=1")
              .ends_with("2:15 warning: this law governs nothing" + hint));
    CHECK(group("key 0 y=0 law-x=hold law-y=hold; key 9 y=1")
              .ends_with("2:11 warning: this law-x governs nothing" + hint));
    CHECK(group("key 0 x=0 law=ease law-x=hold; key 9 x=1")
              .ends_with("2:11 warning: this law governs nothing" + hint));
    CHECK(group("key 0 scale=1 law-y=hold; key 9 scale-x=2")
              .ends_with("2:15 warning: this law-y governs nothing" + hint));
}

TEST_CASE("a match governs drawings")
{
    const auto object = [](const std::string& keys) {
        return read_on_canvas("object o fill=red {\n" + keys + "\n}");
    };
    const auto good = object("key 0 match=length { empty }; key 1 match=count { empty }; key 2 { empty }");
    REQUIRE(good.scene);
    CHECK(good.findings == "");
    CHECK(key_at(*good.scene).match == scene::Match::length);
    CHECK(key_at(*good.scene, 1).match == scene::Match::count);
    CHECK(key_at(*good.scene, 2).match == scene::Match::count);
    const std::string hint = " (remove it, or let a later key set what this one sets)";
    CHECK(object("key 0 { empty }; key 1 match=length { empty }").findings ==
          "4:24 warning: this match governs nothing" + hint);
    CHECK(object("key 0 x=1 match=length; key 1 { empty }").findings ==
          "4:11 warning: this match governs nothing" + hint);
    CHECK(object("key 0 match=area { empty }; key 1 { empty }").findings ==
          "4:13 error: unknown value \"area\" (allowed: count, length, letters)");
}

TEST_CASE("a key sets something")
{
    const auto object = [](const std::string& keys) {
        return items_read("object o fill=red { rect 0 0 2 2; " + keys + " }");
    };
    const std::string error =
        "1:35 error: this key sets nothing (add shapes, \"empty\", or a property such as x=10)";
    CHECK(object("key 5") == error);
    CHECK(object("key 5 {}") == error);
    CHECK(object("key 5 law=hold match=count; key 6 x=2").starts_with(error));
    CHECK(object("key 5 pivot-x=3").starts_with("1:41 error: key has no property \"pivot-x\""));
}

TEST_CASE("keys of groups and uses set properties only")
{
    CHECK(items_read("group { object o fill=red { rect 0 0 2 2 }; key 3 { rect 0 0 1 1 } }") ==
          "1:53 error: key takes no nodes inside (write key TIME law=LAW x=X …)");
    CHECK(items_read("group { object o fill=red { rect 0 0 2 2 }; key 3 fill=red }")
              .starts_with("1:51 error: key has no property \"fill\""));
    CHECK(items_read("group { object o fill=red { rect 0 0 2 2 }; key 3 x=1 match=count }")
              .starts_with("1:55 error: key has no property \"match\""));
}

TEST_CASE("an object has a drawing")
{
    CHECK(items_read("object o fill=red { key 0 x=1; key 3 x=2 }") ==
          "1:1 error: this object has no drawing (add shapes to the object or to its keys)");
    CHECK(items_read("object o fill=red { key soon { empty } }") == "1:25 error: a number is expected here");
    CHECK(items_read("object o fill=red { empty }") == "object o @0");
}

TEST_CASE("\"empty\" stands alone")
{
    const std::string error = " error: \"empty\" stands alone (remove it, or the shapes)";
    CHECK(items_read("object o fill=red { key 0 { line 1 1 2 2; empty } }") == "1:43" + error);
    CHECK(items_read("object o fill=red { key 0 { empty; line 1 1 2 2 } }") == "1:36" + error);
    CHECK(items_read("object o fill=red { key 0 { empty 3 } }") ==
          "1:35 error: this value is too many for empty (write key TIME { empty })");
    CHECK(items_read("object o fill=red { key 0 { empty x=3 } }") ==
          "1:35 error: empty has no property \"x\" (nothing is allowed here)");
}

TEST_CASE("the last key of any kind is the end of a scene without frames=")
{
    CHECK(read_on_canvas("object o fill=red { line 0 0 1 1; key 3 x=1; key 7.5 x=0 }").scene->length ==
          Time{7'680});
    CHECK(read_on_canvas("group { object o fill=red { line 0 0 1 1 }; key 12 y=1 }").scene->length ==
          Time::frame(12));
}

}
