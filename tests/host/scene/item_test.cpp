#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The tracks of a group with these properties, and what was found; column 7 is their first character.
std::string group(const std::string& properties)
{
    return items_read("group " + properties + " { object o fill=red { circle 0 0 r=1 } }");
}

/// What group() gives for tracks alone.
std::string with(const std::string& tracks) { return "group " + tracks + "\n  object o @0"; }

}

TEST_CASE("an item that says nothing of itself has no tracks")
{
    CHECK(group("") == "group\n  object o @0");
    CHECK(group("x=0 y=0 rotate=0 scale=1 opacity=1 order=0 visible=#true") == "group\n  object o @0");
}

TEST_CASE("every property of an item is rounded once to what is stored, halves away from zero")
{
    CHECK(group("x=1.03 y=-0.03125") == with("x[16] y[-1]"));
    CHECK(group("x=-2047 y=2047") == with("x[-32752] y[32752]"));
    CHECK(group("rotate=90") == with("rotation[16384]"));
    CHECK(group("rotate=-5760") == with("rotation[-1048576]"));
    CHECK(group("rotate=1") == with("rotation[182]")); // 182.04
    CHECK(group("rotate=0.0027465820312") == "group\n  object o @0");
    CHECK(group("rotate=0.0027465820313") == with("rotation[1]"));
    CHECK(group("scale-x=-64 scale-y=64") == with("scale_x[-262144] scale_y[262144]"));
    CHECK(group("scale=0.5") == with("scale_x[2048] scale_y[2048]"));
    CHECK(group("opacity=0.5") == with("opacity[128]"));
    CHECK(group("opacity=0") == with("opacity[0]"));
    CHECK(group("order=-32768") == with("order[-32768]"));
    CHECK(group("visible=#false") == with("visible[0]"));
}

TEST_CASE("the scale of one axis wins over that of both, in any order")
{
    CHECK(group("scale=2 scale-y=-1") == with("scale_x[8192] scale_y[-4096]"));
    CHECK(group("scale-x=3 scale=2") == with("scale_x[12288] scale_y[8192]"));
}

TEST_CASE("properties of an item out of range are refused where they are")
{
    CHECK(group("x=2047.5") == "1:9 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(group("scale=2 pivot-y=-2048") ==
          "1:23 error: this number is out of range (allowed: -2047 to 2047)");
    CHECK(group("rotate=5761") == "1:14 error: this number is out of range (allowed: -5760 to 5760)");
    CHECK(group("scale=64.1") == "1:13 error: this number is out of range (allowed: -64 to 64)");
    CHECK(group("scale-x=#nan") == "1:15 error: this number is out of range (allowed: -64 to 64)");
    CHECK(group("opacity=1.01") == "1:15 error: this number is out of range (allowed: 0 to 1)");
    CHECK(group("order=32768") == "1:13 error: this number is out of range (allowed: -32768 to 32767)");
    CHECK(group("order=1.5") == "1:13 error: a whole number is expected here");
    CHECK(group("visible=1") == "1:15 error: #true or #false is expected here");
    CHECK(group("visible=yes") == "1:15 error: #true or #false is expected here");
    CHECK(group("visible=(s)#true") == "1:15 error: this value takes no type or unit (leave out (s))");
    CHECK(group("x=left") == "1:9 error: a number is expected here");
    CHECK(group("fill=red") == "1:7 error: group has no property \"fill\" (allowed: x, y, z, rotate, "
                               "rotate-x, rotate-y, rotate-z, scale, scale-x, scale-y, opacity, order, "
                               "visible, pivot-x, pivot-y, input)");
}

TEST_CASE("objects have the same properties")
{
    CHECK(items_read("object o fill=red x=1 y=2 opacity=0.2 order=3 visible=#false { circle 0 0 r=1 }") ==
          "object o @0 x[16] y[32] opacity[51] order[3] visible[0]");
}

TEST_CASE("the pivot is stored where an item turns or grows, else it is warned of")
{
    CHECK(group("rotate=90 pivot-x=3 pivot-y=-4") == with("rotation[16384] pivot_x[48] pivot_y[-64]"));
    CHECK(group("scale-y=2 pivot-x=3") == with("scale_y[8192] pivot_x[48]"));
    CHECK(group("pivot-x=3 x=1") == with("x[16]") +
                                        "\n1:7 warning: pivot-x does nothing where nothing turns or grows "
                                        "(add rotate=… or scale=…, or remove pivot-x)");
}

TEST_CASE("without a pivot, an object turns about the centre of its first drawing that is not empty")
{
    const auto turned = [](const std::string& inside) {
        return items_read("object o fill=red rotate=90 { " + inside + " }");
    };
    CHECK(turned("rect 10 20 30 40") == "object o @0 rotation[16384] pivot_x[400] pivot_y[640]");
    CHECK(turned("rect 10 20 30 40; line 0 0 60 0") ==
          "object o @0 rotation[16384] pivot_x[480] pivot_y[480]");
    CHECK(turned("key 0 { empty }; key 1 { rect 1 1 2 2 }; key 2 { rect 9 9 9 9 }") ==
          "object o @0,1,2 rotation[16384] pivot_x[32] pivot_y[32]");
    // Control points do not count; the centre is rounded to 1/16 px, halves up.
    CHECK(turned("path \"M0 0C0 50 10 50 10 0\"") == "object o @0 rotation[16384] pivot_x[80]");
    CHECK(turned("line 0 0 0.0625 -0.0625") == "object o @0 rotation[16384] pivot_x[1]");
    CHECK(turned("key 0 { empty }") == "object o @0 rotation[16384]");
    CHECK(items_read("object o fill=red scale=2 pivot-x=0 { rect 10 20 30 40 }") ==
          "object o @0 scale_x[8192] scale_y[8192] pivot_y[640]");
}

}
