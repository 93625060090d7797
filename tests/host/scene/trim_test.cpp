#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("an object, its keys and its tracks say which part of its strokes is drawn")
{
    CHECK(items_read("object o stroke=red trim-from=0.25 trim-to=0.5 trim=together { line 0 0 9 9 }") ==
          "object o @0 trim_from[16384] trim_to[32768] trim[1]");
    CHECK(items_read(
              "object o stroke=red { line 0 0 9 9; key 0 trim-to=0; key 10 trim-to=1 trim-offset=-2 }") ==
          "object o @0 trim_to[0:0 10:65536] trim_offset[0:0 10:-131072]");
    CHECK(items_read("object o fill=red { rect 0 0 9 9; track trim-to { at 0 0; at 5 1 } }") ==
          "object o @0 trim_to~[0:0 5:65536]");
}

TEST_CASE("shares are 0 to 1, and an offset is up to 16 turns")
{
    CHECK(items_read("object o stroke=red trim-to=1.5 { line 0 0 9 9 }")
              .starts_with("1:29 error: this number is out of range (allowed: 0 to 1)"));
    CHECK(items_read("object o stroke=red trim-offset=17 { line 0 0 9 9 }").find("1:33 error: ") !=
          std::string::npos);
    CHECK(items_read("object o stroke=red trim=all { line 0 0 9 9 }").find("allowed: each, together") !=
          std::string::npos);
    CHECK(items_read("group g { track trim-to { at 0 0; at 5 1 }; object o fill=red { rect 0 0 9 9 } }")
              .find("only objects have \"trim-to\"") != std::string::npos);
}

TEST_CASE("a drawing with depth is not trimmed")
{
    const std::string cube = "cuboid 10 10 0 9 9 9";
    for (const std::string& object :
         {"object o stroke=red trim-to=0.5 { " + cube + " }",
          "object o stroke=red { " + cube + "; key 0 trim-from=0; key 5 trim-from=1 }",
          "object o stroke=red { " + cube + "; track trim-to { at 0 0; at 5 1 } }",
          "object o stroke=red trim=each { " + cube + " }"}) {
        CAPTURE(object);
        CHECK(items_read(object).find("a drawing with depth is not trimmed") != std::string::npos);
    }
}

TEST_CASE("an arc that changes its angles is all that it reaches, trimmed")
{
    const std::string read =
        items_read("object o stroke=red { key 0 law=ease { arc 50 50 r=40 from=0 to=90 }\n"
                   "key 10 { arc 50 50 r=40 from=0 to=180 } }");
    CHECK(read.starts_with("object o @0 trim_from[0] trim_to[0:32768("));
    CHECK(read.ends_with("10:65536] trim_offset[0]"));
    const SceneText scene = read_on_canvas("object o stroke=red { key 0 { arc 50 50 r=40 from=0 to=90 }\n"
                                           "key 10 { arc 50 50 r=40 from=0 to=180 } }");
    CHECK(text_of(key_at(*scene.scene).drawing) == drawn("arc 50 50 r=40 from=0 to=180"));
}

TEST_CASE("an arc that also moves or grows has a drawing at each key")
{
    CHECK(items_read("object o stroke=red { key 0 { arc 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { arc 60 50 r=20 from=90 to=180 } }") ==
          "object o @0,10 trim_from[0:0 10:32768] trim_to[0:32768 10:65536] trim_offset[0]");
}

TEST_CASE("an arc that goes around further than a turn is a part of a circle that turns")
{
    CHECK(items_read("object o stroke=red { key 0 { arc 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { arc 50 50 r=40 from=720 to=900 } }") ==
          "object o @0 trim_from[0] trim_to[0:16384 10:32768] trim_offset[0:0 10:131072]");
    // Its direction changes: its ends would have to leave the circle.
    CHECK(items_read("object o stroke=red { key 0 { arc 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { arc 50 50 r=40 from=500 to=400 } }")
              .starts_with("object o @0,10"));
}

TEST_CASE("pies are trimmed by their angles, also where the author trims them")
{
    CHECK(items_read("object o fill=red { key 0 { pie 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { pie 50 50 r=40 from=0 to=180 } }") ==
          "object o @0 trim_from[0] trim_to[0:32768 10:65536] trim_offset[0] trim[2]");
    CHECK(items_read("object o fill=red trim-to=0.5 { pie 50 50 r=40 from=0 to=90 }") ==
          "object o @0 trim_to[32768] trim[2]");
}

TEST_CASE("arcs of ellipses, pieces of rings, and arcs beside others keep their points")
{
    for (const std::string shape :
         {"arc 50 50 rx=40 ry=20", "pie 50 50 r=40 inner=9", "line 1 1 9 9; arc 50 50 r=9"}) {
        CAPTURE(shape);
        CHECK(items_read("object o stroke=red { key 0 { " + shape + " from=0 to=90 }; key 10 { " + shape +
                         " from=0 to=180 } }")
                  .starts_with("object o @0,10"));
    }
    CHECK(items_read("object o stroke=red trim-to=0.5 { key 0 { arc 50 50 r=40 from=0 to=90 }\n"
                     "key 10 { arc 50 50 r=40 from=0 to=180 } }") == "object o @0,10 trim_to[32768]");
}

}
