#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The drawing of an object that holds `shapes`, its depths behind a bar, then what was found.
std::string wired(const std::string& shapes, const std::string& properties = "stroke=red")
{
    const SceneText read = read_on_canvas("object o " + properties + " { " + shapes + " }");
    if (!read.scene)
        return read.findings;
    const scene::Key& key = key_at(*read.scene);
    return text_of(key.drawing) + " | " + text_of(key.depths) +
           (read.findings.empty() ? "" : "\n" + read.findings);
}

std::string findings(const std::string& text) { return read_on_canvas(text).findings; }

std::string in_mesh(const std::string& nodes)
{
    return findings("object o stroke=red { mesh {\n" + nodes + "\n} }");
}

constexpr auto triangle = "vertices 1 2 3 4 5 6 7 8 9";

}

TEST_CASE("a wire goes through points with a depth")
{
    CHECK(wired("wire 1 2 3 4.03 5 -6.5") == "M 1 2 L 4 5 | M 3 0 L -6.5 0");
    CHECK(wired("wire 1 2 3 4 5 6 7 8 9 closed=#true") ==
          "M 1 2 L 4 5 L 7 8 L 1 2 | M 3 0 L 6 0 L 9 0 L 3 0");
    // segments stay even if they have no length, seen from the front or at all
    CHECK(wired("wire 1 2 3 1 2 9 1 2 9") == "M 1 2 L 1 2 L 1 2 | M 3 0 L 9 0 L 9 0");
}

TEST_CASE("the edges of a mesh are drawn once each, in few strokes")
{
    CHECK(wired("mesh { vertices 0 0 0 10 0 0; vertices 10 10 5; edges 1 2 2 3 3 1 }") ==
          "M 0 0 L 10 10 L 10 0 L 0 0 | M 0 0 L 5 0 L 0 0 L 0 0");
    CHECK(wired("mesh { face 1 2 3; vertices 0 0 0 10 0 0 10 10 5; edges 2 1 3 2 }") ==
          "M 0 0 L 10 10 L 10 0 L 0 0 | M 0 0 L 5 0 L 0 0 L 0 0");
}

TEST_CASE("a cuboid has twelve edges in four strokes")
{
    const SceneText read = read_on_canvas("object o stroke=red { cuboid 1 2 3 10 20 30 }");
    REQUIRE(read.scene);
    const scene::Key& key = key_at(*read.scene);
    CHECK(object_at(*read.scene).has_depths);
    CHECK(key.drawing.strokes.size() == 4);
    CHECK(point_count(key.drawing) == 12 + 4);
    CHECK(point_count(key.depths) == 12 + 4);
}

TEST_CASE("the pivot is the middle of the box of x and y")
{
    CHECK(items_read("object o stroke=red rotate-y=1 { wire 10 20 5 30 60 90 }") ==
          "object o @0 rotation_y[182] pivot_x[320] pivot_y[640]");
}

TEST_CASE("the pivot of a wire frame counts even if the object does not turn itself")
{
    CHECK(items_read("object o stroke=red { wire 10 20 5 30 60 90 }") ==
          "object o @0 pivot_x[320] pivot_y[640]");
    CHECK(items_read("object o stroke=red pivot-x=0 pivot-y=1 { wire 10 20 5 30 60 90 }") ==
          "object o @0 pivot_y[16]");
}

TEST_CASE("symbols of wires are placed, but not copied")
{
    const SceneText read =
        read_on_canvas("symbol s { wire 1 2 3 4 5 6 }\nobject o stroke=red { use s 10 20 }");
    REQUIRE(read.scene);
    CHECK(object_at(*read.scene).has_depths);
    CHECK(text_of(key_at(*read.scene).depths) == "M 3 0 L 6 0");
    CHECK(
        findings("symbol s { wire 1 2 3 4 5 6 }\nobject o stroke=red { use s 10 20; use s }")
            .starts_with("4:27 error: the symbol \"s\" has depth, and does not fit here (let its use be all "
                         "that an object draws)"));
}

TEST_CASE("wires go with wires alone")
{
    CHECK(findings("object o stroke=red { wire 1 2 3 4 5 6; circle 1 2 r=3 }") ==
          "3:41 error: flat shapes and such with depth do not go together in one drawing (put them into an "
          "object each, and a group around both)");
    CHECK(findings("object o stroke=red { circle 1 2 r=3; cuboid 1 2 3 4 5 6 }").starts_with("3:39 error: "));
    CHECK(findings("object o stroke=red {\nkey 0 { wire 1 2 3 4 5 6 }\nkey 1 { circle 1 2 r=3 }\n}") ==
          "5:1 error: this drawing is flat, but another key has one with depth (draw it with wire, mesh or "
          "cuboid, or in an object of its own)");
    CHECK(findings("object o stroke=red {\nkey 0 { wire 1 2 3 4 5 6 }\nkey 1 { empty }\n}").empty());
}

TEST_CASE("what wires cannot have is an error")
{
    CHECK(findings("object o fill=red stroke=red { wire 1 2 3 4 5 6 }") ==
          "3:10 error: a drawing with depth has no fill (use stroke=COLOUR alone)");
    CHECK(findings("bones b { bone a 0 0 9 9 }\nobject o stroke=red skin=b { wire 1 2 3 4 5 6 }")
              .find("4:21 error: a drawing with depth has no skin (turn the object, or a group around it)") !=
          std::string::npos);
    CHECK(
        findings("object o stroke=red { key 0 { wire 1 2 3 4 5 6; skeleton { backbone 0 0 9 9; width 9 } } }")
            .find("error: a drawing with depth has no skeleton (turn the object, or a group around it)") !=
        std::string::npos);
    CHECK(findings("object o stroke=red {\nkey 0 match=length { wire 1 2 3 4 5 6 }\nkey 1 { wire 1 2 3 4 5 7 "
                   "}\n}") == "4:1 error: match=length does not work with depth (use match=count)");
    CHECK(findings("input i kind=drawing points=9 { wire 1 2 3 4 5 6 }\nobject o stroke=red live=i")
              .find("3:33 error: the drawing of an input has no node \"wire\"") != std::string::npos);
}

TEST_CASE("points have three numbers")
{
    CHECK(findings("object o stroke=red { wire 1 2 3 4 5 6 7 }") ==
          "3:40 error: this x has no y and no z (every point has three numbers, X Y Z: add what is missing, "
          "or remove this)");
    CHECK(findings("object o stroke=red { wire 1 2 3 4 5 6 7 8 }")
              .starts_with("3:40 error: this x and y have no z ("));
    CHECK(findings("object o stroke=red { wire 1 2 3 }") ==
          "3:23 error: wire needs more values (write wire X Y Z X Y Z … closed=#true)");
    CHECK(findings("object o stroke=red { wire 1 2 3 4 5 3000 }").starts_with("3:38 error: "));
    CHECK(findings("object o stroke=red { wire 1 2 3 4 5 6 close=#true }").starts_with("3:40 error: "));
    CHECK(findings("object o stroke=red { cuboid 1 2 3 4 5 }")
              .starts_with("3:23 error: cuboid needs more values"));
    CHECK(findings("object o stroke=red { cuboid 1 2 3 4 5 -6 }").starts_with("3:40 error: "));
    CHECK(findings("object o stroke=red { cuboid 1 2 3 4 5 4000 }") ==
          "3:23 error: this cuboid reaches more than 2047 px from the origin");
}

TEST_CASE("the edges of a mesh lead from one vertex that there is to another")
{
    const std::string vertices{triangle};
    CHECK(in_mesh(vertices + "\nedges 1 2 3") ==
          "5:11 error: this edge has no other end (add the vertex that it leads to, or remove this one)");
    CHECK(in_mesh(vertices + "\nedges 1 4") ==
          "5:9 error: there is no vertex 4 (this mesh has 3 vertices, counted from 1)");
    CHECK(in_mesh(vertices + "\nface 1 2 99").starts_with("5:10 error: there is no vertex 99 ("));
    CHECK(in_mesh(vertices + "\nedges 0 1").starts_with("5:7 error: "));
    CHECK(in_mesh(vertices + "\nedges 1.5 1").starts_with("5:7 error: "));
    CHECK(in_mesh(vertices + "\nedges 2 2") ==
          "5:9 error: this edge leads from a vertex to itself (name another vertex, or remove the edge)");
    CHECK(in_mesh(vertices + "\nface 1 2 2")
              .starts_with("5:10 error: this edge leads from a vertex to itself"));
    CHECK(in_mesh(vertices + "\nface 1 2").starts_with("5:1 error: face needs more values"));
    CHECK(in_mesh(vertices + "\nedge 1 2").starts_with("5:1 error: a mesh has no node \"edge\""));
    CHECK(in_mesh(vertices) ==
          "3:23 error: this mesh has no edges (write edges A B … or face A B C … into it)");
    CHECK(in_mesh("edges 1 2") ==
          "3:23 error: this mesh has no vertices (write vertices X Y Z X Y Z … into it)");
    CHECK(in_mesh("vertices 1 2 3 4\nedges 1 2").starts_with("4:16 error: this x has no y and no z"));
}

TEST_CASE("a vertex without an edge is a warning")
{
    CHECK(in_mesh("vertices 1 2 3 4 5 6 7 8 9\nedges 1 2") ==
          "4:22 warning: no edge leads to vertex 3, which is not seen (add an edge, or remove the vertex)");
}

}
