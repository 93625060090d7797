#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The tracks of a group with these properties, and what was found; column 7 is their first character.
std::string group(const std::string& properties, const std::string& keys = "")
{
    return items_read("group " + properties + " { object o fill=red { circle 0 0 r=1 }\n" + keys + " }");
}

/// What group() gives for tracks alone.
std::string with(const std::string& tracks) { return "group " + tracks + "\n  object o @0"; }

}

TEST_CASE("items move and turn in space")
{
    CHECK(group("z=-100.5 rotate-x=90 rotate-y=-45 rotate-z=180") ==
          with("z[-1608] rotation_x[16384] rotation_y[-8192] rotation[32768]"));
    CHECK(group("z=0 rotate-x=0 rotate-y=0 rotate-z=0") == "group\n  object o @0");
    CHECK(group("rotate-z=90") == group("rotate=90"));
    CHECK(group("z=2048") == "1:9 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(group("rotate-x=5761") == "1:16 error: this number is out of range (allowed: -5760 to 5760)");
}

TEST_CASE("rotate and rotate-z are two names of one rotation")
{
    const std::string error =
        " error: rotate and rotate-z are the same and both given (leave out one of them)";
    CHECK(group("rotate=1 rotate-z=1") == "1:25" + error);
    CHECK(group("rotate-z=1 rotate=1") == "1:25" + error);
    CHECK(group("", "key 0 rotate=1 rotate-z=2") == "2:25" + error);
}

TEST_CASE("what turns in space has a pivot")
{
    CHECK(items_read("object o fill=red rotate-x=90 { rect 10 20 30 40 }") ==
          "object o @0 rotation_x[16384] pivot_x[400] pivot_y[640]");
    CHECK(items_read("object o fill=red { rect 10 20 30 40; key 0 rotate-y=0; key 9 rotate-y=90 }") ==
          "object o @0 rotation_y[0:0 9:16384] pivot_x[400] pivot_y[640]");
    CHECK(items_read("object o fill=red z=5 { rect 10 20 30 40 }") == "object o @0 z[80]");
}

TEST_CASE("keys move and turn in space by their law")
{
    CHECK(group("", "key 0 z=1 rotate-x=0 rotate-z=0 law=accelerate; key 9 z=2 rotate-x=90 rotate=360") ==
          with("z[0:16(accelerate,accelerate) 9:32] rotation_x[0:0(accelerate,accelerate) 9:16384] "
               "rotation[0:0(accelerate,accelerate) 9:65536]"));
    CHECK(group("", "key 0 z=1 law-x=hold; key 9 z=2")
              .ends_with("2:11 warning: this law-x governs nothing "
                         "(remove it, or let a later key set what this one sets)"));
}

TEST_CASE("uses turn in space")
{
    const std::string symbol = "\nsymbol s { object o fill=red { rect 0 0 2 2 } }";
    CHECK(items_read("use s 1 2 z=3 rotate-y=90 mirror=x" + symbol) ==
          "use s x[16] y[32] z[48] rotation_y[16384] scale_x[-4096]");
}

TEST_CASE("an object that is nothing but a use turns in space, a copy among shapes does not")
{
    const std::string symbol = "\nsymbol s { rect 0 0 2 2 }";
    CHECK(items_read("object o fill=red { use s z=1 rotate-x=90 rotate-y=45 }" + symbol) ==
          "object o @0 z[16] rotation_x[16384] rotation_y[8192]");
    CHECK(items_read("object o fill=red rotate-x=1 { use s rotate-x=90 }" + symbol) ==
          "1:32 error: both the object and its use give rotate-x (leave it to one of them)");
    const std::string error = " error: among shapes a use is a copy, which lies in the plane of its drawing "
                              "(let the use be all that an object draws, or turn the object)";
    CHECK(items_read("object o fill=red { use s z=1; use s }" + symbol) == "1:27" + error);
    CHECK(items_read("object o fill=red { key 0 { use s rotate-x=1 } }" + symbol) == "1:35" + error);
    CHECK(items_read("object o fill=red { key 0 { use s rotate-y=0 } }" + symbol) == "1:35" + error);
}

}
