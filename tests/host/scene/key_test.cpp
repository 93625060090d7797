#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

SceneText object(const std::string& nodes) { return read_on_canvas("object o fill=red {\n" + nodes + "\n}"); }

std::int32_t ticks(const std::string& time, const std::string& rate = "30")
{
    const auto scene =
        read("kfast 1\ncanvas 9 9 fps=" + rate + "\nobject o fill=red { key " + time + " { empty } }").scene;
    REQUIRE(scene);
    return key_at(*scene).time.ticks;
}

scene::Key first_key(const std::string& laws)
{
    const auto scene = object("key 0 " + laws + " { empty }\nkey 9 { empty }").scene;
    REQUIRE(scene);
    return key_at(*scene);
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
    CHECK(object("key -1 { empty }").findings == "4:5 error: a time cannot be negative");
    CHECK(object("key (s)-0.001 { empty }").findings == "4:5 error: a time cannot be negative");
    CHECK(object("key 1000000.001 { empty }").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key #inf { empty }").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key #nan { empty }").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key 1e999 { empty }").findings ==
          "4:5 error: this time is out of range (allowed: up to 1000000 frames)");
    CHECK(object("key soon { empty }").findings == "4:5 error: a number is expected here");
    CHECK(object("key (sec)1 { empty }").findings ==
          "4:5 error: unknown unit \"sec\" (allowed: s, ms (frames have no unit))");
}

TEST_CASE("keys stand in the order of their times, each time once")
{
    CHECK(object("key 0 { empty }\nkey 5 { empty }\nkey 5 { empty }").findings ==
          "6:1 error: there is a key at this time already, on line 5 "
          "(times are rounded to 1/1024 frame; choose another)");
    CHECK(object("key 5 { empty }\nkey 5.0001 { empty }").findings ==
          "5:1 error: there is a key at this time already, on line 4 "
          "(times are rounded to 1/1024 frame; choose another)");
    CHECK(object("key 30 { empty }\nkey (s)1 { empty }").findings ==
          "5:1 error: there is a key at this time already, on line 4 "
          "(times are rounded to 1/1024 frame; choose another)");
    CHECK(object("key 0 { empty }\nkey 9 { empty }\nkey 5 { empty }\nkey 10 { empty }").findings ==
          "6:1 error: this key is earlier than the one before it, on line 5 "
          "(put the keys in the order of their times)");
}

TEST_CASE("every velocity law has its name")
{
    CHECK(first_key("").laws.x == VelocityLaw::constant);
    CHECK(first_key("law=constant").laws.x == VelocityLaw::constant);
    CHECK(first_key("law=accelerate").laws.x == VelocityLaw::accelerate);
    CHECK(first_key("law=decelerate").laws.y == VelocityLaw::decelerate);
    CHECK(first_key("law=accelerate-decelerate").laws.y == VelocityLaw::accelerate_decelerate);
    CHECK(first_key("law=hold").laws.y == VelocityLaw::hold);
    CHECK(first_key("law-x=\"steps(4)\"").laws.x == VelocityLaw::in_steps(4));
    CHECK(first_key("law-y=\"bezier(0,1,1,0)\"").laws.y == VelocityLaw::bezier(0, 8192, 8192, 0));
}

TEST_CASE("the law of one axis wins over that of both, in any order")
{
    const scene::Key after = first_key("law=accelerate law-y=decelerate");
    CHECK(after.laws.x == VelocityLaw::accelerate);
    CHECK(after.laws.y == VelocityLaw::decelerate);
    const scene::Key before = first_key("law-x=decelerate law=accelerate");
    CHECK(before.laws.x == VelocityLaw::decelerate);
    CHECK(before.laws.y == VelocityLaw::accelerate);
    CHECK(first_key("law-y=accelerate").laws.x == VelocityLaw::constant);
}

TEST_CASE("laws with mistakes")
{
    CHECK(object("key 0 law=acelerate { empty }\nkey 1 { empty }").findings ==
          "4:11 error: unknown law \"acelerate\" (did you mean \"accelerate\"?)");
    CHECK(object("key 0 law-z=constant { empty }\nkey 1 { empty }").findings ==
          "4:7 error: key has no property \"law-z\" (did you mean \"law-x\"?)");
    CHECK(object("key 0 speed=1 { empty }\nkey 1 { empty }").findings ==
          "4:7 error: key has no property \"speed\" (allowed: law, law-x, law-y, x, y, z, "
          "rotate, rotate-x, rotate-y, rotate-z, scale, scale-x, scale-y, opacity, order, visible, match, "
          "fill, stroke, width, trim-from, trim-to, trim-offset, dash, dash-offset)");
}

TEST_CASE("a law on the last key is warned of")
{
    const auto text = object("key 0 law=accelerate { empty }\nkey 1 law-x=accelerate { empty }");
    CHECK(text.scene);
    CHECK(text.findings == "5:7 warning: this law-x governs nothing "
                           "(remove it, or let a later key set what this one sets)");
}

TEST_CASE("a key with \"empty\" is an empty drawing, one with several shapes holds them in order")
{
    const auto [scene, findings] = object("key 0 { line 1 1 2 2; circle 5 5 r=0 }\nkey 5 { empty }");
    REQUIRE(scene);
    CHECK(findings == "");
    const auto& keys = object_at(*scene).keys;
    REQUIRE(keys.size() == 2);
    CHECK(text_of(keys[0].drawing) == "M 1 1 L 2 2 M 5 5");
    CHECK(keys[1].drawing.strokes.empty());
}

TEST_CASE("a key of another form is refused")
{
    CHECK(object("key").findings == "4:1 error: key needs more values (write key TIME law=LAW { shapes })");
    CHECK(object("key 1 2").findings ==
          "4:7 error: this value is too many for key (write key TIME law=LAW { shapes })");
    CHECK(object("key 1 { key 2 { empty } }").findings ==
          "4:9 error: a key has no node \"key\" "
          "(allowed: path, circle, ellipse, rect, arc, pie, "
          "polygon, regular, star, line, curve, text, wire, mesh, cuboid, use, empty, skeleton)");
    CHECK(object("key 1 { cirle 1 2 r=3 }").findings ==
          "4:9 error: a key has no node \"cirle\" (did you mean \"circle\"?)");
}

}
