#include "host/compiler/carry/backbone_cells.hpp"

#include "host/compiler/carry/backbone_timeline.hpp"
#include "tests/host/compiler/backbone_parts.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

std::vector<BackboneNode> nodes_of(const std::vector<scene::Backbone>& backbones)
{
    const std::vector keys{skeleton(0, backbones)};
    return BackboneTimeline{keys}.nodes_at({});
}

/// Of a straight band of two segments, from (10, 30) to (30, 30), 10 px to either side.
RelativePoint on_band(Vec2 spot) { return BackboneCells{nodes_of({straight_band(2)})}.place_of(spot); }

void check(const RelativePoint& point, double along, double across)
{
    CHECK(point.along == doctest::Approx(along));
    CHECK(point.across == doctest::Approx(across));
}

/// A corner to the right, then downwards; its mitre is given.
scene::Backbone corner()
{
    return {.nodes = {{160, 160}, {320, 160}, {320, 320}},
            .left = {{160, 96}, {384, 96}, {384, 320}},
            .right = {{160, 224}, {256, 224}, {256, 320}}};
}

}

TEST_CASE("a point lies along the backbone and across it, to the left above 0")
{
    check(on_band({10, 30}), 0, 0);
    check(on_band({15, 25}), 0.5, 0.5);
    check(on_band({27.5, 40}), 1.75, -1);
    CHECK(on_band({15, 25}).distance == 0);
}

TEST_CASE("a point in no cell goes with the nearest that reaches as far")
{
    check(on_band({5, 30}), -0.5, 0);
    check(on_band({38, 20}), 2.8, 1);
    check(on_band({20, 60}), 1, -3);
    CHECK(on_band({20, 60}).distance == doctest::Approx(20));
    CHECK(on_band({20, 60}).is_deformed);
}

TEST_CASE("beyond a segment's length, or eight widths, a point is moved to the nearest cell")
{
    const RelativePoint before = on_band({-5, 30});
    check(before, 0, 0);
    CHECK(!before.is_deformed);
    CHECK(before.distance == doctest::Approx(15));
    const RelativePoint beside = on_band({20, 130});
    CHECK(beside.across == doctest::Approx(-1));
    CHECK(!beside.is_deformed);
}

TEST_CASE("outside of a corner the segments meet on the line of their mitre")
{
    const BackboneCells cells{nodes_of({corner()})};
    CHECK(cells.place_of({25, 3}).along < 1);
    CHECK(cells.place_of({27, 5}).along > 1);
    check(cells.place_of({28, 2}), 1, 2);
}

TEST_CASE("backbones follow each other with a gap of two segments' length")
{
    const BackboneCells cells{nodes_of({straight_band(2), moved(straight_band(3), 0, 640)})};
    check(cells.place_of({12, 30}), 0.2, 0);
    const RelativePoint second = cells.place_of({12, 70});
    check(second, 4.2, 0);
    CHECK(second.backbone == 1);
    CHECK(second.limit == 8);
    CHECK(cells.place_of({12, 30}).limit == 3);
}

TEST_CASE("where cells of two backbones lie over each other, a point goes with the preferred one")
{
    const BackboneCells cells{nodes_of({straight_band(2), moved(straight_band(2), 0, 80)})};
    CHECK(cells.place_of({20, 35}).backbone == 0);
    CHECK(cells.place_of({20, 35}, 1).backbone == 1);
    CHECK(cells.place_of({20, 22}, 1).backbone == 0);
    CHECK(cells.place_on({20, 22}, 1).backbone == 1);
    CHECK(cells.main_backbone(std::vector<Vec2>{{20, 22}, {20, 35}, {20, 43}, {21, 44}}) == 1);
}

TEST_CASE("a cell may end in a point")
{
    const scene::Backbone tail{
        .nodes = {{0, 160}, {160, 160}}, .left = {{0, 80}, {160, 160}}, .right = {{0, 240}, {160, 160}}};
    const BackboneCells cells{nodes_of({tail})};
    check(cells.place_of({10, 10}), 1, 0);
    check(cells.place_of({5, 7.5}), 0.5, 1);
    check(cells.place_of({9, 10.25}), 0.9, -0.5);
}

}
