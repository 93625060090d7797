#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// A group with this inside, and what was found; column 1 of line 2 is its first character.
std::string group(const std::string& inside)
{
    return items_read("group {\n" + inside + "\nobject o fill=red { rect 0 0 2 2 } }");
}

/// What group() gives for tracks alone.
std::string with(const std::string& tracks) { return "group " + tracks + "\n  object o @0"; }

std::string object(const std::string& properties, const std::string& inside)
{
    return items_read("object o " + properties + " {\n" + inside + "\nrect 0 0 2 2 }");
}

}

TEST_CASE("a track goes smoothly through its values, which stand in any order")
{
    CHECK(group("track y { at 0 40; at 15 200; at (s)1 40 }") == with("y~[0:640 15:3200 30:640]"));
    CHECK(group("track y { at 30 1; at 0 2; at 2.5 3 }") == with("y~[0:32 2.5:48 30:16]"));
    CHECK(group("track z { at 7 1 }") == with("z~[7:16]"));
}

TEST_CASE("tracks have the ranges and units of the properties of items")
{
    CHECK(group("track x { at 0 1.03 }; track y { at 0 -1 }; track z { at 0 2 }\n"
                "track rotate { at 0 90 }; track rotate-x { at 0 45 }; track rotate-y { at 0 -360 }\n"
                "track scale-x { at 0 2 }; track scale-y { at 0 -0.5 }; track opacity { at 0 0.5 }\n"
                "track pivot-x { at 0 1 }; track pivot-y { at 0 2 }") ==
          with("x~[16] y~[-16] z~[32] rotation_x~[8192] rotation_y~[-65536] rotation~[16384] scale_x~[8192] "
               "scale_y~[-2048] pivot_x~[16] pivot_y~[32] opacity~[128]"));
    CHECK(group("track rotate-z { at 0 90; at 9 0 }") == with("rotation~[0:16384 9:0]"));
    CHECK(group("track scale { at 0 2; at 9 1 }") == with("scale_x~[0:8192 9:4096] scale_y~[0:8192 9:4096]"));
    CHECK(object("stroke=red", "track width { at 0 0; at 9 4 }") == "object o @0 width~[0:0 9:64]");
    CHECK(group("track opacity { at 0 1.5 }") == "2:22 error: this number is out of range (allowed: 0 to 1)");
    CHECK(group("track x { at 0 -2047.5 }").starts_with("2:16 error: this number is out of range"));
    CHECK(group("track rotate { at -1 left }") == "2:19 error: a time cannot be negative\n"
                                                  "2:22 error: a number is expected here");
}

TEST_CASE("with a law, a track goes by it, or by that of each value")
{
    CHECK(group("track scale-x law=accelerate { at 0 1; at 30 2 law=hold; at 40 1 }") ==
          with("scale_x[0:4096(accelerate,accelerate) 30:8192(hold,hold) 40:4096]"));
    CHECK(group("track y law=constant { at 0 1; at 30 2 law=\"steps(3)\"; at 40 1 }") ==
          with("y[0:16 30:32(steps,steps) 40:16]"));
    CHECK(group("track x { at 0 1; at 30 2 law=hold; at 40 1 }") ==
          "2:27 error: this track is smooth: it goes by no laws (write track x law=constant)");
    CHECK(group("track x law=fast { at 0 1; at 3 1 }").starts_with("2:13 error: unknown law \"fast\""));
}

TEST_CASE("a law of a track that governs nothing is warned of")
{
    const std::string warning = " warning: this law governs nothing (remove it, or add a later value)";
    CHECK(group("track x law=constant { at 9 1 law=hold; at 3 2 }") ==
          with("x[3:32 9:16]") + "\n2:31" + warning);
    CHECK(group("track x law=hold { at 9 1 }") == with("x[9:16]") + "\n2:9" + warning);
}

TEST_CASE("tracks stand in objects, groups and uses")
{
    CHECK(object("fill=red", "track x { at 0 1; at 3 0 }") == "object o @0 x~[0:16 3:0]");
    const std::string symbol =
        "\nsymbol s { object o fill=red { rect 0 0 2 2; track x { at 0 1; at 40 0 } } }";
    CHECK(items_read("use s 3 4 { track z { at 0 1; at 3 0 }; key 0 opacity=0 }" + symbol) ==
          "use s x[48] y[64] z~[0:16 3:0] opacity[0]");
    CHECK(items_read("use s { trak z }" + symbol) ==
          "1:9 error: a use has no node \"trak\" (did you mean \"track\"?)");
    CHECK(items_read("object o fill=red { use s; }\nsymbol s { rect 0 0 2 2; track x { at 0 1 } }")
              .starts_with("2:26 error: a symbol has no node \"track\""));
    CHECK(items_read("group { track x { at 0 1 } }") ==
          "1:1 error: this group holds nothing (add { object NAME … })");
}

TEST_CASE("a mirrored use mirrors its tracks")
{
    const std::string symbol = "\nsymbol s { object o fill=red { rect 0 0 2 2 } }";
    CHECK(items_read("use s mirror=x { track scale-x { at 0 1; at 3 -2 } }" + symbol) ==
          "use s scale_x~[0:-4096 3:8192]");
    CHECK(items_read("use s mirror=y { track scale { at 0 1; at 3 2 } }" + symbol) ==
          "use s scale_x~[0:4096 3:8192] scale_y~[0:-4096 3:-8192]");
    CHECK(items_read("object o fill=red { use d mirror=y; track scale-y { at 0 1; at 3 2 } }\n"
                     "symbol d { rect 0 0 2 2 }") == "object o @0 scale_y~[0:-4096 3:-8192]");
}

TEST_CASE("a track knows what it is a track of")
{
    CHECK(group("track") == "2:1 error: track needs more values (write track QUANTITY { at TIME VALUE })");
    CHECK(group("track x y { at 0 1 }") ==
          "2:9 error: this value is too many for track (write track QUANTITY { at TIME VALUE })");
    CHECK(group("track rotatx-x { at 0 1 }") ==
          "2:7 error: unknown quantity \"rotatx-x\" (did you mean \"rotate-x\"?)");
    CHECK(group("track colour { at 0 1 }")
              .starts_with("2:7 error: unknown quantity \"colour\" (allowed: x, y, z"));
    CHECK(group("track visible { at 0 1 }") ==
          "2:7 error: visible has no track by key times (set it in keys: key 0 visible=…)");
    CHECK(object("fill=red", "track fill { at 0 1 }") ==
          "2:7 error: fill has no track by key times (set it in keys: key 0 fill=…)");
    CHECK(group("track width { at 0 1 }") ==
          "2:7 error: only objects have \"width\" (let the track stand in an object)");
    CHECK(object("fill=red", "track width { at 0 1 }") ==
          "2:1 error: this object has no stroke to change (add stroke=COLOUR to the object)");
    CHECK(group("track x speed=1 { at 0 1 }") ==
          "2:9 error: track has no property \"speed\" (allowed: law, input)");
}

TEST_CASE("a track holds values at different times")
{
    CHECK(group("track x") == "2:1 error: this track has no values (add { at 0 …; at 30 … })");
    CHECK(group("track x { key 0 x=1 }") ==
          "2:11 error: a track has no node \"key\" (KFAST calls it \"at\")");
    CHECK(group("track x { at 0 }") == "2:11 error: at needs more values (write at TIME VALUE)");
    CHECK(group("track x { at 0 1 2 }") == "2:18 error: this value is too many for at (write at TIME VALUE)");
    CHECK(group("track x { at 0 1 lw=hold }").starts_with("2:18 error: at has no property \"lw\""));
    CHECK(group("track x {\nat (s)1 1; at 0 2\nat 30 3 }") ==
          "4:1 error: there is a value at this time already, on line 5 "
          "(times are rounded to 1/1024 frame; choose another)");
}

TEST_CASE("a quantity is given once")
{
    const auto twice = [](const std::string& name, const std::string& giver) {
        return " error: " + name + " is given twice: by this track, and by " + giver +
               " (leave it to one of them)";
    };
    CHECK(object("fill=red x=0", "track x { at 0 1 }") == "2:1" + twice("x", "its item"));
    CHECK(object("fill=red pivot-x=0 scale=2", "track pivot-x { at 0 1 }") ==
          "2:1" + twice("pivot-x", "its item"));
    CHECK(group("key 0 opacity=0\ntrack opacity { at 0 1 }") ==
          "3:1" + twice("opacity", "the key on line 4"));
    CHECK(group("track rotate { at 0 1 }\ntrack rotate-z { at 0 1 }") ==
          "3:1" + twice("rotate", "the track on line 4"));
    CHECK(group("track scale-y { at 0 1 }\ntrack scale { at 0 1 }") ==
          "3:1" + twice("scale-y", "the track on line 4"));
    CHECK(object("stroke=red width=2", "track width { at 0 1 }") == "2:1" + twice("width", "its item"));
    CHECK(object("fill=red scale=2", "track scale-x { at 0 1 }") == "2:1" + twice("scale-x", "its item"));
    CHECK(object("fill=red scale-x=2", "track scale-y { at 0 1 }") ==
          "object o @0 scale_x[8192] scale_y~[4096] pivot_x[16] pivot_y[16]");
    CHECK(items_read("use s 1 2 { track y { at 0 1 } }\nsymbol s { object o fill=red { rect 0 0 2 2 } }") ==
          "1:13" + twice("y", "its item"));
    CHECK(items_read("object o fill=red { use s z=1; track z { at 0 1 } }\nsymbol s { rect 0 0 2 2 }") ==
          "1:32" + twice("z", "its item"));
}

TEST_CASE("a track gives a pivot something to do")
{
    CHECK(object("fill=red", "track rotate-y { at 0 0; at 9 90 }") ==
          "object o @0 rotation_y~[0:0 9:16384] pivot_x[16] pivot_y[16]");
    CHECK(object("fill=red", "track rotate { at 0 0; at 9 90 }; track pivot-x { at 0 5; at 3 6 }") ==
          "object o @0 rotation~[0:0 9:16384] pivot_x~[0:80 3:96] pivot_y[16]");
    CHECK(group("track pivot-y { at 0 5 }") ==
          "group\n  object o @0\n2:1 warning: pivot-y does nothing where nothing turns or grows "
          "(add rotate=… or scale=…, or remove pivot-y)");
}

TEST_CASE("the values of tracks count for the length of a scene")
{
    CHECK(read_on_canvas("object o fill=red { line 0 0 1 1; track x { at 0 1; at 7.5 2 } }").scene->length ==
          Time{7'680});
    const auto at_ten = [](const std::string& track) {
        return read("kfast 1\ncanvas 9 9 frames=10\ngroup { object o fill=red { line 0 0 1 1 }\n" + track +
                    " }")
            .findings;
    };
    const std::string warning = " warning: the scene ends before anything of this value is seen "
                                "(make the scene longer with frames=… or remove the value)";
    CHECK(at_ten("track x law=hold { at 0 1; at 9 1; at 20 2 }") == "");
    CHECK(at_ten("track x law=hold { at 0 1; at 10 1; at 20 2 }") == "4:37" + warning);
    // The curve to a value depends on the value behind it.
    CHECK(at_ten("track x { at 0 1; at 10 1; at 20 2 }") == "");
    CHECK(at_ten("track x { at 30 1; at 0 1; at 10 1; at 20 2 }") == "4:11" + warning);
}

}
