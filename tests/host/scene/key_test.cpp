#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

SceneText object(const std::string& nodes) { return read_on_canvas("object o fill=red {\n" + nodes + "\n}"); }

std::int32_t ticks(const std::string& time, const std::string& rate = "30")
{
    const auto scene =
        read("kfast 1\ncanvas 9 9 fps=" + rate + "\nobject o fill=red { key " + time + " }").scene;
    REQUIRE(scene);
    return scene->objects.at(0).keys.at(0).time.ticks;
}

scene::Key first_key(const std::string& laws)
{
    const auto scene = object("key 0 " + laws + "\nkey 9").scene;
    REQUIRE(scene);
    return scene->objects.at(0).keys.at(0);
}

}

TEST_CASE("times are frames, seconds or milliseconds, rounded once to 1/1024 frame")
{
    CHECK(ticks("0") == 0);
    CHECK(ticks("20") == 20'480);
    CHECK(ticks("2.5") == 2'560);
    CHECK(ticks("0.00048828125") == 1); // half a tick goes up
    CHECK(ticks("0.000488") == 0);
    CHECK(ticks("-0") == 0);
    CHECK(ticks("(s)0.5") == 15'360);
    CHECK(ticks("(ms)500") == 15'360);
    CHECK(ticks("(s)0.1") == 3'072);
    CHECK(ticks("(s)1", "29.97") == 30'689); // 29.97 * 1024 = 30689.28
    CHECK(ticks("(ms)1", "29.97") == 31);
    CHECK(ticks("1000000") == 1'024'000'000);
    CHECK(ticks("(s)1000", "1000") == 1'024'000'000);
}

TEST_CASE("a time that cannot be is refused where it is")
{
    CHECK(object("key -1").findings == "4:5 error: a time cannot be negative");
    CHECK(object("key (s)-0.001").findings == "4:5 error: a time cannot be negative");
    CHECK(object("key 1000000.001").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key #inf").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key #nan").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key 1e999").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key soon").findings == "4:5 error: a number is expected here");
    CHECK(object("key (sec)1").findings ==
          "4:5 error: unknown unit \"sec\" (allowed: s, ms (frames have no unit))");
}

TEST_CASE("keys stand in the order of their times, each time once")
{
    CHECK(object("key 0\nkey 5\nkey 5").findings ==
          "6:1 error: there is a key at this time already, on line 5 "
          "(times are rounded to 1/1024 frame; choose another)");
    CHECK(object("key 5\nkey 5.0001").findings == "5:1 error: there is a key at this time already, on line 4 "
                                                  "(times are rounded to 1/1024 frame; choose another)");
    CHECK(object("key 30\nkey (s)1").findings == "5:1 error: there is a key at this time already, on line 4 "
                                                 "(times are rounded to 1/1024 frame; choose another)");
    CHECK(object("key 0\nkey 9\nkey 5\nkey 10").findings ==
          "6:1 error: this key is earlier than the one before it, on line 5 "
          "(put the keys in the order of their times)");
}

TEST_CASE("every velocity law has its name")
{
    CHECK(first_key("").law_x == VelocityLaw::constant);
    CHECK(first_key("law=constant").law_x == VelocityLaw::constant);
    CHECK(first_key("law=accelerate").law_x == VelocityLaw::accelerate);
    CHECK(first_key("law=decelerate").law_y == VelocityLaw::decelerate);
    CHECK(first_key("law=accelerate-decelerate").law_y == VelocityLaw::accelerate_decelerate);
}

TEST_CASE("the law of one axis wins over that of both, in any order")
{
    const scene::Key after = first_key("law=accelerate law-y=decelerate");
    CHECK(after.law_x == VelocityLaw::accelerate);
    CHECK(after.law_y == VelocityLaw::decelerate);
    const scene::Key before = first_key("law-x=decelerate law=accelerate");
    CHECK(before.law_x == VelocityLaw::decelerate);
    CHECK(before.law_y == VelocityLaw::accelerate);
    CHECK(first_key("law-y=accelerate").law_x == VelocityLaw::constant);
}

TEST_CASE("laws with mistakes")
{
    CHECK(object("key 0 law=acelerate\nkey 1").findings ==
          "4:11 error: unknown value \"acelerate\" (did you mean \"accelerate\"?)");
    CHECK(object("key 0 law=bounce\nkey 1").findings ==
          "4:11 error: unknown value \"bounce\" "
          "(allowed: constant, accelerate, decelerate, accelerate-decelerate)");
    CHECK(object("key 0 law-z=constant\nkey 1").findings ==
          "4:7 error: key has no property \"law-z\" (did you mean \"law-x\"?)");
    CHECK(object("key 0 speed=1\nkey 1").findings ==
          "4:7 error: key has no property \"speed\" (allowed: law, law-x, law-y)");
}

TEST_CASE("a law on the last key is warned of")
{
    const auto text = object("key 0 law=accelerate\nkey 1 law-x=accelerate");
    CHECK(text.scene);
    CHECK(text.findings == "5:7 warning: a law on the last key governs nothing "
                           "(remove it, or add a later key)");
}

TEST_CASE("a key without shapes is an empty drawing, one with several holds them in order")
{
    const auto [scene, findings] = object("key 0 { line 1 1 2 2; circle 5 5 r=0 }\nkey 5\nkey 6 {}");
    REQUIRE(scene);
    CHECK(findings == "");
    const auto& keys = scene->objects.at(0).keys;
    REQUIRE(keys.size() == 3);
    CHECK(text_of(keys[0].drawing) == "M 1 1 L 2 2 M 5 5");
    CHECK(keys[1].drawing.strokes.empty());
    CHECK(keys[2].drawing.strokes.empty());
}

TEST_CASE("a key of another form is refused")
{
    CHECK(object("key").findings == "4:1 error: key needs more values (write key TIME law=LAW { shapes })");
    CHECK(object("key 1 2").findings ==
          "4:7 error: this value is too many for key (write key TIME law=LAW { shapes })");
    CHECK(object("key 1 { key 2 }").findings == "4:9 error: a key has no node \"key\" "
                                                "(allowed: path, circle, ellipse, rect, polygon, line)");
    CHECK(object("key 1 { cirle 1 2 r=3 }").findings ==
          "4:9 error: a key has no node \"cirle\" (did you mean \"circle\"?)");
}

}
