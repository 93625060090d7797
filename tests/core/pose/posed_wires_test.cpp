#include "core/pose/posed_strokes.hpp"

#include "core/pose/object_strokes.hpp"
#include "core/pose/scene_state.hpp"
#include "core/scene_walk.hpp"
#include "tests/core/beam/beam_player_fixture.hpp"
#include "tests/core/math/exact_space.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

constexpr double precision = 1.0 / 16; // px
constexpr double turn = 1.0 / 360;

/// What is told to an outline.
struct Seen {
    std::vector<std::vector<Point>> strokes;
    std::vector<bool> closed;

    void begin(Point from) { strokes.push_back({from}); }
    void add(const Segment& segment) { strokes.back().push_back(segment.to); }
    void end(Point, bool is_closed) { closed.push_back(is_closed); }
};

/// The outermost item, or what the groups around it hold.
Seen seen_in(const Bytes& bytes, Size panel, Time time)
{
    const SceneView scene = accepted(bytes);
    MovedScene moved{scene};
    SceneOnPanel shown = on_panel(scene, panel, Fit::contain);
    shown.prepared = moved.at(time);
    std::vector<Space> spaces(scene.records().spaces);
    shown.spaces = spaces;
    SceneWalk walk{shown, SceneWalk::Opacity::of_groups};
    REQUIRE(walk.next() == SceneWalk::Step::leaf);
    REQUIRE(walk.node().has_depths);
    Seen seen;
    ObjectStrokes{shown, walk.node()}.trace(Projection{walk.space(), shown.camera}, seen);
    return seen;
}

double in_pixels(Fixed value) { return value.raw() / 65536.0; }

bool are_near(Point point, Spot exact)
{
    return std::abs(in_pixels(point.x) - exact.x) <= precision &&
           std::abs(in_pixels(point.y) - exact.y) <= precision;
}

/// Whether some stroke has a vertex there.
bool has_vertex(const Seen& seen, Spot exact)
{
    return std::ranges::any_of(seen.strokes, [exact](const std::vector<Point>& stroke) {
        return std::ranges::any_of(stroke, [exact](Point point) { return are_near(point, exact); });
    });
}

std::vector<Place> corners_of(Place min, Place size)
{
    std::vector<Place> corners;
    corners.reserve(8);
    for (int i = 0; i < 8; ++i)
        corners.push_back(
            {min.x + (i & 1) * size.x, min.y + (i >> 1 & 1) * size.y, min.z + (i >> 2) * size.z});
    return corners;
}

std::string number(double value) { return std::to_string(value); }

}

TEST_CASE("the corners of a turning cuboid are seen where they must be")
{
    std::mt19937 random{3};
    const auto any = [&random](int min, int max) {
        return min + static_cast<int>(random() % static_cast<unsigned>(max - min + 1));
    };
    for (int round = rounds(200); round > 0; --round) {
        const Place min{any(40, 100) * 1.0, any(40, 100) * 1.0, any(-60, 0) * 1.0};
        const Place size{any(10, 120) * 1.0, any(10, 120) * 1.0, any(10, 120) * 1.0};
        const int camera = any(300, 900);
        const ItemValues inner{.position = {any(-20, 20) * 1.0, any(-20, 20) * 1.0, any(-40, 40) * 1.0},
                               .pivot = {any(0, 240) * 1.0, any(0, 240) * 1.0},
                               .scale = {any(2, 6) / 4.0, any(2, 6) / 4.0},
                               .turns_x = any(-180, 180) * turn,
                               .turns_y = any(-180, 180) * turn,
                               .turns = any(-180, 180) * turn};
        const ItemValues outer{.pivot = {120, 120}, .turns_y = any(-60, 60) * turn};
        const std::string text =
            "kfast 1\ncanvas 240 240 camera=" + std::to_string(camera) +
            "\ngroup pivot-x=120 pivot-y=120 rotate-y=" + number(outer.turns_y / turn) +
            " { object o stroke=white x=" + number(inner.position.x) + " y=" + number(inner.position.y) +
            " z=" + number(inner.position.z) + " pivot-x=" + number(inner.pivot.x) +
            " pivot-y=" + number(inner.pivot.y) + " scale-x=" + number(inner.scale.x) +
            " scale-y=" + number(inner.scale.y) + " rotate-x=" + number(inner.turns_x / turn) +
            " rotate-y=" + number(inner.turns_y / turn) + " rotate=" + number(inner.turns / turn) +
            " { cuboid " + number(min.x) + " " + number(min.y) + " " + number(min.z) + " " + number(size.x) +
            " " + number(size.y) + " " + number(size.z) + " } }";
        CAPTURE(text);
        const Seen shown = seen_in(compiled(text), {240, 240}, {});
        CHECK(shown.strokes.size() == 4);
        for (const Place& corner : corners_of(min, size))
            CHECK(has_vertex(shown, seen(outer(inner(corner)), {120, 120}, camera)));
    }
}

TEST_CASE("without any turn, too, what is nearer is seen larger; on a larger panel as well")
{
    const Bytes bytes = compiled("kfast 1\ncanvas 100 100 camera=200\n"
                                 "object o stroke=white { wire 50 50 0  60 50 100  60 30 -200 }");
    for (const int scale : {1, 3}) {
        const Seen shown = seen_in(bytes, {100 * scale, 100 * scale}, {});
        REQUIRE(shown.strokes.size() == 1);
        REQUIRE(shown.strokes[0].size() == 3);
        CHECK(are_near(shown.strokes[0][0], {50.0 * scale, 50.0 * scale}));
        CHECK(are_near(shown.strokes[0][1], {70.0 * scale, 50.0 * scale}));
        CHECK(are_near(shown.strokes[0][2], {55.0 * scale, 40.0 * scale}));
    }
}

TEST_CASE("points tween in x, y and z, z by the law for x")
{
    const Bytes bytes = compiled("kfast 1\ncanvas 100 100 camera=200 frames=20\nobject o stroke=white {\n"
                                 "key 0 law-y=hold law-x=constant { wire 50 50 0  60 50 0 }\n"
                                 "key 10 { wire 50 50 0  80 70 -400 }\n}");
    const Seen shown = seen_in(bytes, {100, 100}, Time::frame(5));
    CHECK(are_near(shown.strokes[0][1], {60, 50})); // 70, 50 at a depth of 200
}

TEST_CASE("strokes are equalized as flat ones are, and grow out of nothing")
{
    const Bytes bytes =
        compiled("kfast 1\ncanvas 100 100 camera=200 frames=30\nobject o stroke=white {\n"
                 "key 0 { wire 50 50 0 60 50 0 }\n"
                 "key 10 { wire 50 50 0 60 50 0; wire 50 60 200 60 60 0 60 70 0 }\nkey 20 { empty }\n}");
    const Seen between = seen_in(bytes, {100, 100}, Time::frame(5));
    REQUIRE(between.strokes.size() == 2);
    CHECK(between.strokes[1].size() == 3);
    const Seen shrinking = seen_in(bytes, {100, 100}, Time::frame(15));
    REQUIRE(shrinking.strokes.size() == 2);
    // halfway from 50, 60, 200 to the middle, 55, 65, 100: 52.5, 62.5, 150
    CHECK(are_near(shrinking.strokes[1][0], {50 + 4 * 2.5, 50 + 4 * 12.5}));
}

TEST_CASE("a wire is closed where it ends in space as it began, not where it only looks so")
{
    const auto closed = [](const std::string& wire) {
        return static_cast<bool>(
            seen_in(compiled("kfast 1\ncanvas 100 100\nobject o stroke=white { " + wire + " }"), {100, 100},
                    {})
                .closed.at(0));
    };
    CHECK(closed("wire 1 1 1 20 1 1 1 20 1 closed=#true"));
    CHECK(closed("wire 1 1 1 20 1 1 1 20 1 1 1 1"));
    CHECK_FALSE(closed("wire 1 1 1 20 1 1 1 20 1"));
    CHECK_FALSE(closed("wire 1 1 1 20 1 1 1 20 1 1 1 2"));
}

TEST_CASE("a line is as wide as one that faces the viewer at the pivot, however the wires turn")
{
    // a line along the axis of the turn
    const auto width_of = [](const std::string& properties) {
        PlayerFixture fixture{
            "kfast 1\ncanvas 64 64 camera=100\nobject o stroke=white width=8 pivot-x=32 pivot-y=32 " +
                properties + " { wire 32 -20 0 32 90 0 }",
            {64, 64}};
        const Bytes pixels = fixture.picture<PixelFormat::grey4>({});
        const std::string row = row_text(Bytes(pixels.begin() + 32 * 32, pixels.begin() + 33 * 32));
        return std::ranges::count(row, 'f');
    };
    CHECK(width_of("") == 8);
    CHECK(width_of("rotate-y=90") == 8);
    CHECK(width_of("rotate-y=37") == 8);
    CHECK(width_of("z=50") == 16);
    CHECK(width_of("rotate-y=90 z=50") == 16);
    CHECK(width_of("scale-x=2 scale-y=2 rotate-y=30") == 16);
}

TEST_CASE("a beam draws wires where a panel shows them")
{
    BeamPlayerFixture fixture{"kfast 1\ncanvas 256 256 camera=512\n"
                              "object o stroke=white { wire 128 128 0  160 128 256  128 192 -512 }"};
    const auto points = fixture.points({});
    const auto is_drawn = [&](int x, int y) {
        return std::ranges::any_of(points, [&](const BeamPoint& point) {
            return std::abs(point.at.x - x) <= 16 && std::abs(point.at.y - y) <= 16;
        });
    };
    CHECK(is_drawn(0, 0));
    CHECK(is_drawn(64 * 256, 0));
    CHECK(is_drawn(0, -32 * 256));
}

TEST_CASE("wires that only their depth moves do not stand still")
{
    const std::string text =
        "kfast 1\ncanvas 60 60 camera=60 frames=20\nobject o stroke=white width=2 {\n"
        "key 0 { wire 10 10 0 50 10 0 50 50 0 }\nkey 20 { wire 10 10 -60 50 10 0 50 50 0 }\n}";
    PlayerFixture on_the_way{text, {60, 60}};
    on_the_way.picture({});
    PlayerFixture at_once{text, {60, 60}};
    for (const int frame : {1, 7, 13, 19}) {
        const Bytes picture = on_the_way.picture(Time::frame(frame));
        CHECK(picture == at_once.picture(Time::frame(frame)));
        CHECK(picture != on_the_way.picture({}));
    }
}

}
