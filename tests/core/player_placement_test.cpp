#include "core/player.hpp"

#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <array>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Where groups, uses and objects put what is in them: the picture must be that of shapes which are written
/// where they come to lie.
namespace kfast::test {
namespace {

std::string scene_with(const std::string& items)
{
    return "kfast 1\ncanvas 40 40 background=\"#102030\" frames=20\n" + items;
}

Bytes picture_of(const std::string& items, Time time = {})
{
    return PlayerFixture{scene_with(items), {40, 40}}.picture(time);
}

/// Whether no channel of a pixel differs by more than a step of five bits: corners are placed after they were
/// rounded, so that the same outline may come to lie 1/64 px further on.
bool looks_same(const Bytes& a, const Bytes& b)
{
    const auto channel = [](const Bytes& picture, std::size_t at, int shift, int bits) {
        const int pixel = std::to_integer<int>(picture[at]) | std::to_integer<int>(picture[at + 1]) << 8;
        return (pixel >> shift & ((1 << bits) - 1)) >> (bits - 5);
    };
    for (std::size_t at = 0; at < a.size(); at += 2)
        for (const auto& [shift, bits] : {std::pair{0, 5}, std::pair{5, 6}, std::pair{11, 5}})
            if (std::abs(channel(a, at, shift, bits) - channel(b, at, shift, bits)) > 1)
                return false;
    return true;
}

void check_same(const std::string& placed, const std::string& written, Time time = {})
{
    CAPTURE(placed);
    CAPTURE(written);
    const Bytes picture = picture_of(written, time);
    CHECK(picture != picture_of("", time));
    CHECK(looks_same(picture_of(placed, time), picture));
}

const std::string style = " fill=red stroke=white width=2.5 join=round cap=round ";

struct Spot {
    int x;
    int y;
};

/// A map of whole pixels: quarter turns, mirrors and moves.
struct GridMap {
    std::array<int, 4> matrix{1, 0, 0, 1}; ///< xx, xy, yx, yy
    Spot shift{0, 0};

    Spot operator()(Spot p) const
    {
        return {matrix[0] * p.x + matrix[1] * p.y + shift.x, matrix[2] * p.x + matrix[3] * p.y + shift.y};
    }
};

/// A step of a chain of groups, and what it does.
struct Step {
    std::string properties;
    GridMap map;
};

Step random_step(std::mt19937& random)
{
    const auto below = [&random](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    const Spot move{below(9) - 4, below(9) - 4};
    const Spot pivot{below(40), below(40)};
    const int turns = below(4);
    const int across = below(2) * 2 - 1;
    const int down = below(2) * 2 - 1;
    constexpr std::array<std::array<int, 4>, 4> rotations{
        {{1, 0, 0, 1}, {0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}}};
    const auto& r = rotations[static_cast<std::size_t>(turns)];
    GridMap map{{r[0] * across, r[1] * down, r[2] * across, r[3] * down}, {0, 0}};
    const Spot turned_pivot = map(pivot);
    map.shift = {move.x + pivot.x - turned_pivot.x, move.y + pivot.y - turned_pivot.y};
    std::ostringstream text;
    text << " x=" << move.x << " y=" << move.y << " rotate=" << turns * 90 << " scale-x=" << across
         << " scale-y=" << down << " pivot-x=" << pivot.x << " pivot-y=" << pivot.y;
    return {text.str(), map};
}

std::string polygon(const std::vector<Spot>& spots, const std::string& properties = "")
{
    std::ostringstream text;
    text << "object o" << style << properties << " { polygon";
    for (const Spot spot : spots)
        text << ' ' << spot.x << ' ' << spot.y;
    text << " }\n";
    return text.str();
}

}

TEST_CASE("a group by whole pixels aside is what is written there")
{
    check_same("group x=7 y=-3 { object o" + style + "{ path \"M 5 9 C 20 0 30 30 12 25 L 3 20\" } }",
               "object o" + style + "{ path \"M 12 6 C 27 -3 37 27 19 22 L 10 17\" }");
    check_same("group x=7 { group y=5 { object o" + style + " x=-2 y=1 { circle 12 12 r=7 } } }",
               "object o" + style + "{ circle 17 18 r=7 }");
}

TEST_CASE("a group moves what is tweened inside")
{
    const auto tween = [](const std::string& from, const std::string& to) {
        return "object o" + style + "{ key 0 law=accelerate { " + from + " }; key 20 { " + to + " } }";
    };
    for (const int frame : {0, 3, 11, 19})
        check_same("group x=4 y=9 { " + tween("circle 10 10 r=6", "rect 20 10 9 15") + " }",
                   tween("circle 14 19 r=6", "rect 24 19 9 15"), Time::frame(frame));
}

TEST_CASE("quarter turns are clockwise about the pivot")
{
    const std::string written = "object o" + style + "{ polygon 36 10 16 24 20 10 }";
    check_same("group rotate=90 pivot-x=20 pivot-y=20 { object o" + style + "{ polygon 10 4 24 24 10 20 } }",
               written);
    check_same("object o" + style + "rotate=90 pivot-x=20 pivot-y=20 { polygon 10 4 24 24 10 20 }", written);
    check_same("group rotate=-270 x=40 { object o" + style + "{ polygon 10 4 24 24 10 20 } }", written);
}

TEST_CASE("scales make shapes and lines larger")
{
    check_same("object o stroke=white width=1.5 scale=2 pivot-x=0 pivot-y=0 { polygon 3 3 15 4 8 16 }",
               "object o stroke=white width=3 { polygon 6 6 30 8 16 32 }");
    check_same("group scale-x=2 { object o fill=white { polygon 3 3 15 4 8 16 } }",
               "object o fill=white { polygon 6 3 30 4 16 16 }");
    check_same("group scale-x=4 scale-y=1 { object o stroke=white width=2 { line 2 8 8 8 } }",
               "object o stroke=white width=4 { line 8 8 32 8 }"); // by the root of what areas grow by
}

TEST_CASE("mirrors exchange left and right, or up and down, and leave lines alone")
{
    check_same("group scale-x=-1 x=40 { object o" + style + "{ path \"M 5 9 C 20 0 30 30 12 25 L 3 20\" } }",
               "object o" + style + "{ path \"M 35 9 C 20 0 10 30 28 25 L 37 20\" }");
    check_same("group scale-y=-1 pivot-y=20 { object o" + style + "{ polygon 5 9 30 20 11 35 } }",
               "object o" + style + "{ polygon 5 31 30 20 11 5 }");
    const std::string symbol = "symbol s { object o" + style + "{ polygon 5 9 10 20 1 15 } }\n";
    check_same(symbol + "use s 20 0 mirror=x", "object o" + style + "{ polygon 15 9 10 20 19 15 }");
    check_same(symbol + "use s 20 30 mirror=both", "object o" + style + "{ polygon 15 21 10 10 19 15 }");
}

TEST_CASE("any chain of quarter turns, mirrors and moves is what is written where it leads to")
{
    std::mt19937 random{71};
    for (int round = 0; round < rounds(60); ++round) {
        std::vector<Spot> spots(3 + random() % 3);
        for (Spot& spot : spots)
            spot = {static_cast<int>(random() % 40), static_cast<int>(random() % 40)};
        const Step innermost = random_step(random);
        std::string placed = polygon(spots, innermost.properties);
        std::vector<GridMap> maps{innermost.map};
        for (auto depth = random() % 8; depth > 0; --depth) {
            const Step step = random_step(random);
            placed = "group" + step.properties + " {\n" + placed + "}\n";
            maps.push_back(step.map);
        }
        for (const GridMap& map : maps)
            for (Spot& spot : spots)
                spot = map(spot);
        const std::string written = polygon(spots);
        CAPTURE(placed);
        CAPTURE(written);
        REQUIRE(looks_same(picture_of(placed), picture_of(written)));
    }
}

TEST_CASE("a symbol that is used twice is as good as two copies")
{
    const auto inside = [](const std::string& name) {
        return "object " + name + style +
               "rotate=30 { key 0 { circle 9 9 r=6 }; key 20 { rect 4 4 9 5 } }\n"
               "group x=3 { object in-" +
               name + " fill=blue { rect 2 2 4 4 } }\n";
    };
    for (const int frame : {0, 7, 13})
        check_same("symbol s {\n" + inside("o") + "}\nuse s; use s 20 20 rotate=45",
                   "group {\n" + inside("a") + "}\ngroup x=20 y=20 rotate=45 {\n" + inside("b") + "}\n",
                   Time::frame(frame));
}

TEST_CASE("symbols in symbols are placed by all that they are used in")
{
    check_same("symbol a { object o" + style +
                   "{ polygon 1 1 4 1 4 6 1 6 } }\n"
                   "symbol b { use a 5 5; use a 20 2 rotate=90 }\n"
                   "use b 2 2; group y=20 { use b 30 4 mirror=x }",
               "object a" + style + "{ polygon 8 8 11 8 11 13 8 13 }\n" +         //
                   "object b" + style + "{ polygon 21 5 21 8 16 8 16 5 }\n" +     //
                   "object c" + style + "{ polygon 24 30 21 30 21 35 24 35 }\n" + //
                   "object d" + style + "{ polygon 11 27 11 30 16 30 16 27 }\n");
}

TEST_CASE("keys of a group move all that is inside, and only that")
{
    for (const int frame : {0, 5, 15, 19}) {
        const std::string x = std::to_string(frame);
        check_same("object still fill=blue { rect 1 1 9 9 }\n"
                   "group { key 0 x=0; key 20 x=20; object o" +
                       style + "{ circle 12 20 r=6 } }",
                   "object still fill=blue { rect 1 1 9 9 }\n"
                   "object o" +
                       style + "x=" + x + " { circle 12 20 r=6 }",
                   Time::frame(frame));
    }
}

TEST_CASE("the panel's map applies to all that is placed")
{
    const auto on_panel = [](const std::string& items) {
        return PlayerFixture{scene_with(items), {80, 100}}.picture({});
    };
    CHECK(on_panel("group x=7 y=4 { object o" + style + "{ polygon 3 3 15 4 8 16 } }") ==
          on_panel("object o" + style + "{ polygon 10 7 22 8 15 20 }"));
}

TEST_CASE("orders apply among what lies beside each other")
{
    const std::string red = "object r fill=red { rect 5 5 20 20 }\n";
    const std::string blue = "object b fill=blue { rect 10 10 20 20 }\n";
    const auto with_order = [](std::string object, int order) {
        return object.insert(object.find('{'), "order=" + std::to_string(order) + " ");
    };
    check_same(red + with_order(blue, -1), blue + red);
    check_same(with_order(red, 2) + with_order(blue, 1), blue + red);
    check_same("group { " + with_order(red, 9) + "}\n" + blue, red + blue);
    check_same("group order=1 { " + red + "}\n" + blue, blue + red);
    const std::string moving =
        "object r fill=red { key 0 order=0 { rect 5 5 20 20 }; key 10 order=1; key 15 order=0 }\n" + blue;
    check_same(moving, red + blue, Time::frame(9));
    check_same(moving, blue + red, Time::frame(10));
    check_same(moving, red + blue, Time::frame(15));
}

TEST_CASE("width and colours go along their tracks")
{
    check_same("object o stroke=white width=2 { key 0 { line 5 20 35 20 }; key 20 width=12 }",
               "object o stroke=white width=7 { line 5 20 35 20 }", Time::frame(10));
    check_same("object o fill=red stroke=white { key 0 { rect 5 5 20 20 }; key 5 fill=red stroke=white; "
               "key 15 fill=blue stroke=black }",
               "object o fill=\"#800080\" stroke=\"#808080\" { rect 5 5 20 20 }", Time::frame(10));
    PlayerFixture thin{scene_with("object o stroke=white { key 0 { line 5 20 35 20 }; key 20 width=0 }"),
                       {40, 40}};
    thin.player.show_moment(Time::frame(20));
    Bytes pixels(40 * 40 * 2);
    thin.player.draw_rows<PixelFormat::rgb565>(40, pixels);
    CHECK(pixels == picture_of(""));
}

TEST_CASE("what two outlines go around is a hole by the rule even-odd, not by nonzero")
{
    const auto ring = [](const std::string& rule) {
        return row_text(PlayerFixture{
            "kfast 1\ncanvas 4 4\nobject o fill=white rule=" + rule + " { rect 0 0 4 4; rect 1 1 2 2 }",
            {4, 4}}.picture<PixelFormat::grey4>({}));
    };
    CHECK(ring("nonzero") == "ffffffffffffffff");
    CHECK(ring("even-odd") == "fffff00ff00fffff");
}

}
