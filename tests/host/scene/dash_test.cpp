#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>
#include <string>

namespace kfast::test {
namespace {

bool has_finding(const std::string& object, const std::string& what)
{
    CAPTURE(object);
    return items_read(object).find(what) != std::string::npos;
}

}

TEST_CASE("an object and its keys say how its strokes are dashed")
{
    CHECK(items_read("object o stroke=red dash=\"8 4.5\" dash-offset=-3 { line 0 0 9 9 }") ==
          "object o @0 dash_offset[-192] dash_1[512] gap_1[288]");
    CHECK(
        items_read(
            "object o stroke=red { line 0 0 9 9; key 0 dash=\"8, 4\"; key 10 dash=\"1 2\" dash-offset=6 }") ==
        "object o @0 dash_offset[0:0 10:384] dash_1[0:512 10:64] gap_1[0:256 10:128]");
    CHECK(items_read("object o stroke=red dash=4 { line 0 0 9 9; track dash-offset { at 0 0; at 5 8 } }") ==
          "object o @0 dash_offset~[0:0 5:512] dash_1[256] gap_1[256]");
}

TEST_CASE("an odd number of lengths repeats, and so do fewer in one key than in another")
{
    CHECK(items_read("object o stroke=red dash=\"3 2 1\" { line 0 0 9 9 }") ==
          "object o @0 dash_1[192] gap_1[128] dash_2[64] gap_2[192] dash_3[128] gap_3[64]");
    CHECK(items_read("object o stroke=red { line 0 0 9 9; key 0 dash=2; key 9 dash=\"4 3 2 1\" }") ==
          "object o @0 dash_1[0:128 9:256] gap_1[0:128 9:192] dash_2[0:128 9:128] gap_2[0:128 9:64]");
    CHECK(has_finding("object o stroke=red { line 0 0 9 9; key 0 dash=\"1 2 3 4\"; key 9 dash=\"1 2 3\" }",
                      "4 lengths do not become the 6 of another key"));
}

TEST_CASE("lengths may be expressions")
{
    CHECK(items_read("let a=6\nobject o stroke=red dash=\"a a/2\" { line 0 0 9 9 }")
              .find("dash_1[384] gap_1[192]") != std::string::npos);
}

TEST_CASE("patterns with mistakes")
{
    for (const std::string dash : {"\"\"", "\"1 2 3 4 5\"", "\"1 2 3 4 5 6 7\""})
        CHECK(has_finding("object o stroke=red dash=" + dash + " { line 0 0 9 9 }",
                          "a pattern has 1, 2, 3, 4 or 6 lengths"));
    CHECK(has_finding("object o stroke=red dash=\"4 -1\" { line 0 0 9 9 }", "out of range"));
    CHECK(has_finding("object o stroke=red dash=\"4 much\" { line 0 0 9 9 }", "error"));
    CHECK(has_finding("object o stroke=red dash=-4 { line 0 0 9 9 }", "out of range"));
    CHECK(has_finding("object o stroke=red dash-offset=20000 dash=4 { line 0 0 9 9 }", "out of range"));
    CHECK(has_finding("object o stroke=red dash-offset=2 { line 0 0 9 9 }",
                      "dash-offset does nothing without dashes"));
    CHECK(has_finding("object o stroke=red { line 0 0 9 9; key 0 x=0; key 9 dash=4 }",
                      "a later key has dashes, but the first one has none"));
    CHECK(has_finding("object o stroke=red { line 0 0 9 9; track dash { at 0 4; at 9 8 } }",
                      "dash has no track by key times"));
    CHECK(has_finding("object o fill=red { rect 0 0 9 9; key 0 dash=4 }",
                      "this object has no stroke to change"));
    CHECK(has_finding("object o fill=red dash=4 { rect 0 0 9 9 }",
                      "1:19 error: this object has no stroke to dash (add stroke=COLOUR, or remove dash)"));
    CHECK(has_finding("object o fill=red dash-offset=4 { rect 0 0 9 9 }",
                      "error: this object has no stroke to dash"));
    CHECK(has_finding("object o stroke=red dash=4 { cuboid 10 10 0 9 9 9 }",
                      "a drawing with depth is not dashed"));
}

TEST_CASE("a player draws up to 1024 dashes of an object")
{
    CHECK(items_read("object o stroke=red dash=1 { line 0 0 200 0 }").find("max_dashes[127]") !=
          std::string::npos);
    CHECK(has_finding("object o stroke=red dash=\"0.05 0.05\" { line 0 0 200 0 }",
                      "error: these strokes come to 21"));
    CHECK(items_read("object o stroke=red dash=\"0 0\" { line 0 0 200 0 }") == "object o @0");
}

TEST_CASE("dashes between keys count as well")
{
    const std::string line = "{ line 0 0 600 0; key 0 dash=\"20 20\"";
    CHECK(has_finding("object o stroke=red " + line + "; key 9 dash=\"4 4\" }", "max_dashes[95]"));
    // Beyond the key to a pattern of some 2.4 px
    CHECK(has_finding("object o stroke=red " + line + " law=back; key 9 dash=\"4 4\" }", "max_dashes[158]"));
    CHECK(has_finding("object o stroke=red " + line + " law=hold; key 9 dash=\"0 0\" }",
                      "gap_1[0:1280(hold,hold) 9:0]"));
    CHECK(has_finding("object o stroke=red { key 0 law=back { line 0 0 100 0 }; key 9 { line 0 0 900 0 } }",
                      "object o @0,9"));
    CHECK(has_finding("object o stroke=red dash=5 { key 0 law=back { line 0 0 100 0 }\n"
                      "key 9 { line 0 0 900 0 } }",
                      "max_dashes[127]"));
}

TEST_CASE("dashes that shrink to nothing are too many, which is told at their key")
{
    const std::string shrinks = "object o stroke=red { line 0 0 600 0; key 0 dash=\"20 20\"\nkey 9 dash=";
    const std::string read = items_read(shrinks + "\"0 0\" }");
    CHECK(read.find("max_dashes[1024]") != std::string::npos);
    CHECK(read.find("2:1 warning: between keys these strokes may come to more than 1024 dashes; the rest of "
                    "them is drawn whole (let only the gaps become 0, as in dash=\"20 0\", or only the "
                    "dashes; or keep both longer)") != std::string::npos);
    CHECK_FALSE(has_finding(shrinks + "\"20 0\" }", "warning"));
    CHECK_FALSE(has_finding(shrinks + "\"0 20\" }", "warning"));
}

TEST_CASE("bones may stretch what is dashed")
{
    const auto limit = [](const std::string& skeleton) {
        const SceneText read = read_on_canvas("bones s { " + skeleton +
                                              " }\nobject o stroke=red dash=1 skin=s { line 0 9 60 9 }");
        CAPTURE(read.findings);
        REQUIRE(read.scene);
        const scene::Track& last = read.scene->items[0].tracks.back();
        CHECK(last.property == Property::max_dashes);
        return last.keys[0].value;
    };
    CHECK(limit("bone b 0 9 60 9") == 78); // 31 dashes
    CHECK(limit("bone b 0 9 60 9; pose 0 { b length=60 }; pose 9 { b length=180 }") == 233);
    CHECK(limit("bone b 0 9 60 9; pose 0 law=back { b length=60 }; pose 9 { b length=180 }") == 248);
    CHECK(limit("bone b 0 9 60 9; pose 0 { b x=0 y=9 }; pose 9 { b x=9 y=90 }") == 78);
    CHECK(limit("bone b 0 9 30 9; bone c 30 9 60 9; pose 0 { c x=30 y=0 }; pose 9 { c x=90 y=0 }") == 1024);
}

TEST_CASE("backbones may stretch what is dashed")
{
    const auto object = [](const std::string& end) {
        return items_read("object o stroke=red dash=1 { line 10 50 70 50\n"
                          "key 0 { skeleton { backbone 10 50 70 50; width 9 } }\n"
                          "key 9 { skeleton { backbone 10 50 " +
                          end + "; width 9 } } }");
    };
    CHECK(object("70 50").find("max_dashes[78]") != std::string::npos);
    CHECK(object("190 50").find("max_dashes[233]") != std::string::npos);
}

TEST_CASE("dashed pies change their points, so that their lines are dashed")
{
    CHECK(items_read("object o stroke=red dash=4 { key 0 { pie 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { pie 50 50 r=40 from=0 to=180 } }")
              .starts_with("object o @0,10 dash_1"));
    CHECK(items_read("object o stroke=red dash=4 { key 0 { arc 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { arc 50 50 r=40 from=0 to=180 } }")
              .starts_with("object o @0 trim_from[0] trim_to"));
}

}
