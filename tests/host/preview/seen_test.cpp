#include "host/preview/overlay/posed_scene.hpp"
#include "host/preview/overlay/seen_strokes.hpp"

#include "tests/host/preview/named_scene.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <map>
#include <string>

namespace kfast::test {
namespace {

double pixels(Fixed length) { return static_cast<double>(length.raw()) / Fixed::one; }

double distance(Point a, Point b) { return std::hypot(pixels(a.x) - pixels(b.x), pixels(a.y) - pixels(b.y)); }

/// Looks at the leaves of a scene at a moment, by their names.
void look(const NamedScene& scene, Time moment, Size panel,
          const std::function<void(const PosedScene&, const SeenLeaf&, const std::string&)>& look_at)
{
    PosedScene posed{scene.view(), panel, Fit::contain};
    posed.visit(moment, [&](const SeenLeaf& leaf) { look_at(posed, leaf, scene.names()[leaf.number()]); });
}

/// Of the first stroke of the only leaf.
std::vector<SeenStroke> strokes_at(const NamedScene& scene, Time moment)
{
    std::vector<SeenStroke> strokes;
    look(scene, moment, scene.view().canvas(),
         [&](const PosedScene& posed, const SeenLeaf& leaf, const std::string&) {
             strokes = seen_strokes(posed, leaf);
         });
    return strokes;
}

/// Lines that lie on three bones as set up and are carried by one each.
constexpr const char* puppet = R"(kfast 1
canvas 120 100 frames=30
bones arm {
    bone upper 20 40 50 40 { bone lower 50 40 80 52 { bone hand 80 52 80 70 } }
    pose 0 { upper turn=10 }
    pose 20 law=accelerate { upper turn=80 length=36; lower turn=-120; hand turn=45 x=4 }
    pose 30 { upper turn=-40; lower length=20 }
}
group all x=12 y=-3 rotate=30 scale=1.3 {
    object upper-line stroke=red width=1 skin=arm bone=upper { path "M 20 40 L 50 40" }
    object lower-line stroke=lime width=1 skin=arm bone=lower { path "M 50 40 L 80 52" }
    object hand-line stroke=blue width=1 skin=arm bone=hand { path "M 80 52 L 80 70" }
    KEYS
}
)";

std::string with_keys(const std::string& keys)
{
    std::string text = puppet;
    return text.replace(text.find("KEYS"), 4, keys);
}

void check_bones(const NamedScene& scene, Size panel, double tolerance)
{
    for (const int ticks : {0, 700, 5000, 12'345, 20'480, 27'000, 30'720}) {
        CAPTURE(ticks);
        int lines = 0;
        look(scene, {ticks}, panel,
             [&](const PosedScene& posed, const SeenLeaf& leaf, const std::string& name) {
                 const std::size_t number = name == "upper-line" ? 0 : name == "lower-line" ? 1 : 2;
                 const auto bones = seen_bones(posed, leaf.item.object.skeleton, leaf.space);
                 REQUIRE(bones.size() == 3);
                 const auto strokes = seen_strokes(posed, leaf);
                 REQUIRE(strokes.size() == 1);
                 REQUIRE(strokes[0].points.size() == 2);
                 CHECK(distance(strokes[0].points[0], bones[number].origin) < tolerance);
                 CHECK(distance(strokes[0].points[1], bones[number].tip) < tolerance);
                 ++lines;
             });
        CHECK(lines == 3);
    }
}

}

TEST_CASE("bones lie where the lines lie that they carry, in groups and on larger panels")
{
    const NamedScene scene{with_keys("")};
    check_bones(scene, {120, 100}, 0.05);
    check_bones(scene, {480, 320}, 0.2);
}

TEST_CASE("bones are seen in perspective like what they carry")
{
    check_bones(NamedScene{with_keys("key 0 rotate-y=20 rotate-x=-30; key 30 rotate-y=70")}, {120, 100},
                0.05);
}

TEST_CASE("backbones lie where the line through their nodes lies, and their outlines at its sides")
{
    const NamedScene scene{"kfast 1\ncanvas 60 40 frames=20\nobject worm stroke=red width=1 {\n"
                           "    key 0 { path \"M 10 20 L 30 20 L 50 20\"\n"
                           "        skeleton { backbone 10 20 30 20 50 20; width 8 } }\n"
                           "    key 20 { skeleton { backbone 10 20 30 8 50 14 } }\n}\n"};
    for (const int frame : {0, 7, 13, 20}) {
        CAPTURE(frame);
        look(scene, Time::frame(frame), {120, 80},
             [&](const PosedScene& posed, const SeenLeaf& leaf, const std::string&) {
                 const auto backbones = seen_backbones(posed, leaf);
                 const auto strokes = seen_strokes(posed, leaf);
                 REQUIRE(backbones.size() == 1);
                 REQUIRE(backbones[0].nodes.size() == 3);
                 REQUIRE(backbones[0].left.size() == 3);
                 REQUIRE(strokes.size() == 1);
                 for (std::size_t i = 0; i < 3; ++i)
                     CHECK(distance(strokes[0].points[i], backbones[0].nodes[i]) < 0.1);
                 if (frame != 0)
                     return;
                 CHECK(distance(backbones[0].nodes[1], backbones[0].left[1]) == 8);
                 CHECK(distance(backbones[0].nodes[1], backbones[0].right[1]) == 8);
                 CHECK(distance(backbones[0].left[1], backbones[0].right[1]) == 16);
             });
    }
}

TEST_CASE("strokes and points are those that are tweened: as many as the partner with more")
{
    const NamedScene scene{
        "kfast 1\ncanvas 60 40 frames=20\nobject shape fill=red {\n"
        "    key 0 { path \"M 0 0 L 20 0 L 20 20 Z\" }\n"
        "    key 10 { path \"M 0 0 H 10 L 14 8 L 10 20 H 0 Z M 30 30 L 40 30 L 40 40 Z\" }\n"
        "    key 20 { path \"M 4 4 L 9 4 L 9 9 Z\" }\n}\n"};
    const auto on_key = strokes_at(scene, Time::frame(0));
    REQUIRE(on_key.size() == 1);
    CHECK(on_key[0].points.size() == 3);
    CHECK(on_key[0].is_closed);
    const auto between = strokes_at(scene, Time::frame(5));
    REQUIRE(between.size() == 2);
    CHECK(strokes_at(scene, Time::frame(15)).size() == 2);
    CHECK(strokes_at(scene, Time::frame(10)).size() == 2);
    CHECK(strokes_at(scene, Time::frame(10))[0].points.size() == 5);
    std::size_t segments = 0;
    for (const SeenStroke& stroke : between)
        segments += stroke.line.size() - 1;
    CHECK(segments == 8);
}

TEST_CASE(
    "at a key, points are numbered as on the way that begins there, and at the last one as on the way there")
{
    const NamedScene scene{"kfast 1\ncanvas 60 40 frames=20\nobject shape stroke=red width=1 {\n"
                           "    key 0 { path \"M 0 0 L 20 0 L 20 20 M 30 0 L 50 0\" }\n"
                           "    key 10 law=hold { path \"M 0 20 L 12 20 L 24 20 L 36 20\" }\n"
                           "    key 20 { path \"M 4 4 L 9 4 M 4 9 L 9 9 M 4 14 L 9 14\" }\n}\n"};
    std::vector<std::vector<SeenStroke>> at;
    for (const int frame : {0, 5, 10, 15, 20})
        look(scene, Time::frame(frame), {60, 40},
             [&](const PosedScene& posed, const SeenLeaf& leaf, const std::string&) {
                 at.push_back(matched_strokes(posed, leaf));
             });
    REQUIRE(at.size() == 5);
    CHECK(at[0].size() == 2);
    CHECK(at[1].size() == 2);
    for (const std::size_t i : {2U, 3U, 4U})
        CHECK(at[i].size() == 3);
    REQUIRE(at[0][0].points.size() == at[1][0].points.size());
    for (std::size_t i = 0; i < at[0][0].points.size(); ++i) // half of the way from their places at the key
        CHECK(distance(at[0][0].points[i], at[1][0].points[i]) < 25);
    CHECK(distance(at[0][1].points.front(), {Fixed::pixels(30), {}}) < 0.01);
    CHECK(distance(at[2][2].points.back(), {Fixed::pixels(36), Fixed::pixels(20)}) < 0.01);
    CHECK(distance(at[4][2].points.back(), {Fixed::pixels(9), Fixed::pixels(14)}) < 0.01);
    CHECK(strokes_at(scene, Time::frame(10)).size() == 1);
}

TEST_CASE("skins, backbones and wire frames are numbered so, too, and a single key as it is drawn")
{
    const NamedScene scene{
        "kfast 1\ncanvas 60 40 frames=20\n"
        "bones arm { bone upper 10 10 30 10 }\n"
        "object skinned stroke=red width=1 skin=arm bone=upper {\n"
        "    key 0 { path \"M 10 10 L 30 10\" }\n"
        "    key 20 { path \"M 10 10 L 20 10 L 30 10\" }\n}\n"
        "object worm stroke=red width=1 {\n"
        "    key 0 { path \"M 10 20 L 50 20\"; skeleton { backbone 10 20 30 20 50 20; width 8 } }\n"
        "    key 20 { path \"M 10 20 L 30 20 M 30 20 L 50 20\"; skeleton { backbone 10 20 30 8 50 14 } "
        "}\n}\n"
        "object cage stroke=red width=1 {\n"
        "    key 0 { wire 10 10 0 20 10 0 }\n"
        "    key 20 { wire 10 10 0 20 10 0; wire 10 20 5 20 20 5 }\n}\n"
        "object still stroke=red width=1 { key 0 { path \"M 0 0 L 9 9\" } }\n"};
    const auto points = [](const std::vector<SeenStroke>& strokes) {
        std::size_t count = 0;
        for (const SeenStroke& stroke : strokes)
            count += stroke.points.size();
        return count;
    };
    std::map<std::string, std::size_t> at_first;
    look(scene, Time::frame(0), {60, 40},
         [&](const PosedScene& posed, const SeenLeaf& leaf, const std::string& name) {
             CAPTURE(name);
             at_first[name] = points(matched_strokes(posed, leaf));
             CHECK((points(seen_strokes(posed, leaf)) == at_first[name]) == (name == "still"));
         });
    CHECK(at_first.size() == 4);
    look(scene, Time::frame(20), {60, 40},
         [&](const PosedScene& posed, const SeenLeaf& leaf, const std::string& name) {
             CAPTURE(name);
             CHECK(points(matched_strokes(posed, leaf)) == at_first[name]);
         });
}

TEST_CASE("points tween, each with its own number")
{
    const NamedScene scene{"kfast 1\ncanvas 60 40 frames=20\nobject line stroke=red width=1 {\n"
                           "    key 0 law=constant { path \"M 0 0 L 10 0 L 20 0\" }\n"
                           "    key 20 { path \"M 0 8 L 10 16 L 20 32\" }\n}\n"};
    const auto strokes = strokes_at(scene, Time::frame(5));
    REQUIRE(strokes.size() == 1);
    CHECK(strokes[0].points == std::vector<Point>{{{}, Fixed::pixels(2)},
                                                  {Fixed::pixels(10), Fixed::pixels(4)},
                                                  {Fixed::pixels(20), Fixed::pixels(8)}});
    CHECK_FALSE(strokes[0].is_closed);
    CHECK(strokes[0].line == strokes[0].points);
    CHECK(strokes[0].controls.empty());
}

TEST_CASE("a curve has two control points, at its ends")
{
    const NamedScene scene{
        "kfast 1\ncanvas 60 40\nobject line stroke=red width=1 { path \"M 0 0 C 4 8 12 16 20 0\" }\n"};
    const auto strokes = strokes_at(scene, {});
    REQUIRE(strokes.size() == 1);
    REQUIRE(strokes[0].controls.size() == 2);
    CHECK(strokes[0].controls[0].from == Point{});
    CHECK(strokes[0].controls[0].to == Point{Fixed::pixels(4), Fixed::pixels(8)});
    CHECK(strokes[0].controls[1].from == Point{Fixed::pixels(20), {}});
    CHECK(strokes[0].controls[1].to == Point{Fixed::pixels(12), Fixed::pixels(16)});
    CHECK(strokes[0].line.size() > 3);
}

TEST_CASE("what is invisible is not visited, and what a symbol holds once for each use")
{
    const NamedScene scene{"kfast 1\ncanvas 60 40\nsymbol pair {\n    object a fill=red { circle 5 5 r=2 }\n"
                           "    object b fill=red { circle 9 5 r=2 }\n}\n"
                           "use pair\nobject hidden fill=red visible=#false { circle 5 5 r=2 }\n"
                           "group g { use pair x=20 }\n"};
    std::vector<std::string> names;
    look(scene, {}, {60, 40}, [&](const PosedScene&, const SeenLeaf& leaf, const std::string& name) {
        std::string path;
        for (const std::size_t number : leaf.numbers.first(leaf.numbers.size() - 1))
            path += scene.names()[number] + '/';
        names.push_back(path + name);
    });
    CHECK(names == std::vector<std::string>{"pair/a", "pair/b", "g/pair/a", "g/pair/b"});
}

}
