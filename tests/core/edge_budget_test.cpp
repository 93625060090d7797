#include "core/edge_budget.hpp"

#include "core/player.hpp"
#include "tests/compiled.hpp"

#include <doctest/doctest.h>
#include <initializer_list>
#include <string>

namespace kfast::test {
namespace {

/// Shows the drawing with that style on a panel that cuts nothing off, and compares.
void check_bound(const std::string& style, const std::string& drawing)
{
    CAPTURE(style);
    CAPTURE(drawing);
    const auto bytes = compiled("kfast 1\ncanvas 200 200\nobject it " + style + " { " + drawing + " }");
    const SceneView scene = *SceneView::parse(bytes);
    std::vector<std::byte> block(Player::block_bytes(scene, scene.canvas()));
    const auto player = Player::create(scene, scene.canvas(), Fit::contain, block);
    CHECK(player->edge_count() <= scene.max_edges());
}

}

TEST_CASE("the bound on edges holds for every cap and join, for lines and curves, open and closed")
{
    for (const std::string drawing :
         {"line 40 40 100 45 60 100 110 120", "polygon 40 40 100 45 60 100 110 120",
          "path \"M 60 60 C 160 63 60 163 61 61\"", "path \"M 60 60 C 160 63 60 163 61 61 Z\"",
          "path \"M 90 90 C 130 91 70 92 110 93\"", "circle 100 100 r=40", "circle 100 100 r=3"}) {
        check_bound("fill=white", drawing);
        for (const std::string cap : {"butt", "round", "square"})
            for (const std::string join : {"miter", "round", "bevel"})
                for (const std::string width : {"0.25", "3", "50"})
                    check_bound("stroke=white width=" + width + " cap=" + cap + " join=" + join, drawing);
    }
}

TEST_CASE("the bound holds wherever the object is placed, however it is stretched")
{
    for (const std::string placing :
         {"rotate=33 scale-x=-3 scale-y=0.5", "scale=20", "scale=0.02 rotate=-100", "scale-x=0",
          "scale-x=-64 scale-y=64 pivot-x=0 pivot-y=0"})
        for (const std::string drawing : {"polygon 40 40 100 45 60 100 110 120", "circle 100 100 r=40",
                                          "path \"M 60 60 C 160 63 60 163 61 61\""})
            for (const std::string style : {"fill=white stroke=white width=0.25 join=round cap=round",
                                            "stroke=white width=50 cap=square"})
                check_bound(style + " " + placing, drawing);
}

TEST_CASE("an object needs what the largest way between two of its keys needs")
{
    const auto edges = [](const std::string& keys) {
        const auto bytes =
            compiled("kfast 1\ncanvas 200 200 frames=9\nobject it fill=white { " + keys + " }");
        return SceneView::parse(bytes)->items().next().object.max_edges;
    };
    const std::string triangle = "{ polygon 0 0 9 0 0 9 }";
    const std::string square = "{ polygon 0 0 9 0 9 9 0 9 }";
    const std::string hexagon = "{ regular 9 9 r=9 sides=6 }";
    CHECK(edges("key 0 " + triangle + "; key 2 " + square) == 4 + 2);
    CHECK(edges("key 0 " + triangle + "; key 2 " + hexagon + "; key 4 " + triangle) == 6 + 2);
    CHECK(edges("key 0 " + hexagon + "; key 2 { empty }") == 6 + 2);
}

TEST_CASE("the bound of simple drawings is what their outlines can need, and no more")
{
    const auto bound = [](const std::string& style, const std::string& drawing) {
        const auto bytes = compiled("kfast 1\ncanvas 200 200\nobject it " + style + " { " + drawing + " }");
        return SceneView::parse(bytes)->max_edges();
    };
    CHECK(bound("fill=white", "polygon 0 0 9 0 0 9") == 3 + 2); // closed by way of its hub
    // two sides, a join of two inner and two outer edges, two caps, and as much again if it were closed
    CHECK(bound("stroke=white", "line 0 0 9 0") == 2 + 4 + 2 * 1 + 2 + 4);
    CHECK(bound("stroke=white cap=square", "line 0 0 9 0") == 2 + 4 + 2 * 3 + 2 + 4);
    CHECK(bound("stroke=white join=bevel", "line 0 0 9 0 9 9") == 2 * (2 + 3) + 2 * 1 + 2 + 3);
    const auto arc = static_cast<std::uint32_t>(arc_pieces(16));
    CHECK(bound("stroke=white cap=round join=round", "line 0 0 9 0") == 2 + 2 + arc + 2 * arc + 2 + 2 + arc);
    CHECK(bound("fill=white stroke=white", "line 0 0 9 0") == 14 + 1 + 2);
}

}
