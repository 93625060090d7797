#include "host/program/failure.hpp"
#include "tests/host/lottie/shape_list.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string group(const std::string& items, const std::string& transform = R"({"ty": "tr"})")
{
    return R"({"ty": "gr", "nm": "group", "it": [)" + items + ", " + transform + "]}";
}

std::string only_loss(const std::string& items)
{
    const ReadShapes read = read_shapes(items);
    REQUIRE(read.losses.list().size() == 1);
    CHECK(read.losses.list()[0].layer == "layer");
    return read.losses.list()[0].feature;
}

}

TEST_CASE("a style paints all paths before it, as one, and nothing behind it")
{
    const ReadShapes read = read_shapes(square + ',' + line + ',' + red + ',' + square);
    REQUIRE(read.nodes.size() == 1);
    CHECK(shape(read.nodes[0]).drawing.value().outlines.size() == 2);
    CHECK(shape(read.nodes[0]).fill->colour.value() == art::Rgb{1, 0, 0});
    CHECK_FALSE(shape(read.nodes[0]).stroke);
    CHECK(read.losses.empty());
}

TEST_CASE("the first style of a list lies on top")
{
    const ReadShapes read = read_shapes(square + ',' + red + ',' + blue);
    REQUIRE(read.nodes.size() == 2);
    CHECK(shape(read.nodes[0]).fill->colour.value() == art::Rgb{0, 0, 1});
    CHECK(shape(read.nodes[1]).fill->colour.value() == art::Rgb{1, 0, 0});
}

TEST_CASE("a stroke above a fill of the same paths is one figure with it")
{
    const ReadShapes together = read_shapes(square + ',' + stroke + ',' + red);
    REQUIRE(together.nodes.size() == 1);
    CHECK(shape(together.nodes[0]).fill);
    CHECK(shape(together.nodes[0]).stroke->width.value() == 2);
    CHECK(read_shapes(square + ',' + red + ',' + stroke).nodes.size() == 2);
    CHECK(read_shapes(square + ',' + stroke + ',' + line + ',' + red).nodes.size() == 2);
}

TEST_CASE("a group of one figure is that figure, with the name and the transform of the group")
{
    const ReadShapes read = read_shapes(
        group(square + ',' + red, R"({"ty": "tr", "p": {"k": [5, 6]}, "r": {"k": 30}, "o": {"k": 50}})"));
    REQUIRE(read.nodes.size() == 1);
    CHECK(read.nodes[0].name == "group");
    CHECK(read.nodes[0].transform.x.value() == 5);
    CHECK(read.nodes[0].transform.rotate.value() == 30);
    CHECK(read.nodes[0].opacity.value() == 0.5);
    CHECK(shape(read.nodes[0]).drawing.value().outlines[0].from.x == 6);
}

TEST_CASE("a group of several figures is a group, and nothing is one without figures")
{
    const ReadShapes read = read_shapes(group(square + ',' + red + ',' + blue) + ',' + group(square));
    REQUIRE(read.nodes.size() == 1);
    CHECK(inside(read.nodes[0]).size() == 2);
    CHECK(inside(read.nodes[0])[0].name == "square");
}

TEST_CASE("a still transform between a path and its style goes into the points")
{
    const ReadShapes read = read_shapes(
        group(square, R"({"ty": "tr", "p": {"k": [100, 0]}, "s": {"k": [200, 100]}})") + ',' + red);
    REQUIRE(read.nodes.size() == 1);
    CHECK(read.nodes[0].transform == art::Transform{});
    CHECK(shape(read.nodes[0]).drawing.value().outlines[0].from.x == 112);
}

TEST_CASE("a figure whose paths all move with one group lies in it")
{
    const std::string moving = R"({"ty": "tr", "p": )" + even("[0, 0]", "[50, 0]") + '}';
    const ReadShapes read = read_shapes(group(square, moving) + ',' + red);
    REQUIRE(read.nodes.size() == 1);
    CHECK(read.nodes[0].transform.x.at(5) == 25);
    CHECK(shape(read.nodes[0]).drawing.is_still());
}

TEST_CASE("paths that move apart are baked; where all goes evenly, two keys do")
{
    const std::string moving = R"({"ty": "tr", "p": )" + even("[0, 0]", "[50, 0]") + '}';
    const ReadShapes read = read_shapes(group(square, moving) + ',' + line + ',' + red);
    REQUIRE(read.nodes.size() == 1);
    const auto& drawing = shape(read.nodes[0]).drawing;
    CHECK(drawing.keys.size() == 2);
    CHECK(drawing.at(10).outlines[0].from.x == 56);
    CHECK(drawing.at(10).outlines[1].from.x == 0);
}

TEST_CASE("a stroke does not lie in a group that grows: its width stays")
{
    const std::string growing = R"({"ty": "tr", "s": )" + even("[100, 100]", "[200, 200]") + '}';
    const ReadShapes read = read_shapes(group(square, growing) + ',' + stroke);
    CHECK(read.nodes[0].transform == art::Transform{});
    CHECK(shape(read.nodes[0]).drawing.at(10).outlines[0].from.x == 12);
}

TEST_CASE("what is hidden is left out")
{
    const std::string hidden = R"({"ty": "fl", "hd": true, "c": {"k": [0, 0, 1, 1]}})";
    CHECK(read_shapes(square + ',' + hidden).nodes.empty());
}

TEST_CASE("an ease of a size is that of the drawing")
{
    const std::string size =
        R"({"a": 1, "k": [{"t": 0, "s": [10, 10], "o": {"x": [0.3], "y": [0]}, "i": {"x": [0.6], "y": [1]}},
                                               {"t": 20, "s": [30, 30]}]})";
    const ReadShapes read = read_shapes(R"({"ty": "el", "p": {"k": [0, 0]}, "s": )" + size + "}, " + red);
    const auto& drawing = shape(read.nodes[0]).drawing;
    REQUIRE(drawing.keys.size() == 2);
    CHECK(drawing.keys[0].ease == art::Ease{art::EaseKind::cubic, 0.3, 0, 0.6, 1});
}

TEST_CASE("gradients become their mean colour, as much of each as is seen, and are reported")
{
    const std::string gradient =
        R"({"ty": "gf", "o": {"k": 100}, "g": {"p": 2, "k": {"k": [0, 1, 0, 0, 1, 0, 0, 1)";
    const ReadShapes plain = read_shapes(square + ',' + gradient + "]}}}");
    CHECK(shape(plain.nodes[0]).fill->colour.value().red == doctest::Approx(0.5));
    CHECK(shape(plain.nodes[0]).fill->opacity.value() == doctest::Approx(1));
    REQUIRE(plain.losses.list().size() == 1);
    CHECK(plain.losses.list()[0].feature == "gradient of a fill");
    const ReadShapes fading = read_shapes(square + ',' + gradient + ", 0, 1, 1, 0]}}}");
    CHECK(shape(fading.nodes[0]).fill->colour.value().red == doctest::Approx(2.0 / 3).epsilon(0.001));
    CHECK(shape(fading.nodes[0]).fill->opacity.value() == doctest::Approx(0.5));
}

TEST_CASE("what is not carried over is reported")
{
    CHECK(only_loss(R"({"ty": "pb", "a": {"k": 20}})") == "pucker and bloat");
    CHECK(only_loss(R"({"ty": "xy"})") == "shape of type \"xy\"");
    CHECK(only_loss(square + ',' + line + R"(, {"ty": "mm", "mm": 3}, )" + red) == "merge paths: subtract");
    CHECK(only_loss(square + R"(, {"ty": "fl", "bm": 1, "c": {"k": [1, 0, 0, 1]}})") == "blend mode");
    CHECK(only_loss(R"({"ty": "fl", "c": {"k": [1, 0, 0, 1]}, "shade": 1})") ==
          "member \"shade\" of a shape \"fl\"");
    CHECK(read_shapes(R"({"ty": "el", "closed": true, "p": {"k": [0, 0]}, "s": {"k": [8, 8]}}, )" + red)
              .losses.empty());
    CHECK(read_shapes(square + ',' + line + R"(, {"ty": "mm", "mm": 1}, )" + red).losses.empty());
}

TEST_CASE("what is no shape, or asks for too much, is refused")
{
    CHECK_THROWS_AS(read_shapes("3"), Failure);
    CHECK_THROWS_AS(read_shapes(square + R"(, {"ty": "rp", "c": {"k": 1000000}})"), Failure);
    std::string repeaters = square;
    for (int i = 0; i < 9; ++i)
        repeaters += R"(, {"ty": "rp", "c": {"k": 1}})";
    CHECK_THROWS_AS(read_shapes(repeaters), Failure);
    std::string trims = square;
    for (int i = 0; i < 65; ++i)
        trims += R"(, {"ty": "tm", "e": {"k": 50}})";
    CHECK_THROWS_AS(read_shapes(trims), Failure);
    std::string deep = square;
    for (int i = 0; i < 70; ++i)
        deep = group(deep);
    CHECK_THROWS_AS(read_shapes(deep), Failure);
}

TEST_CASE("trims of many changing paths as one, one after the other, end soon")
{
    std::string items;
    for (int i = 0; i < 50; ++i)
        items += R"({"ty": "el", "p": {"k": [0, 0]}, "s": )" + even("[1, 1]", "[9, 9]") + "}, ";
    for (int i = 0; i < 30; ++i)
        items += R"({"ty": "tm", "m": 2, "e": {"k": 50}}, )";
    CHECK_THROWS_AS(read_shapes(items + red), Failure);
}
