#include "host/art/geometry/curves.hpp"
#include "tests/host/lottie/shape_list.hpp"

#include <algorithm>
#include <doctest/doctest.h>

#include <cmath>

using namespace kfast;
using namespace kfast::test;

namespace {

art::Drawing drawing_at(const std::string& items, double time)
{
    const ReadShapes read = read_shapes(items);
    REQUIRE(read.nodes.size() == 1);
    return shape(read.nodes[0]).drawing.at(time);
}

std::string trim(const std::string& members) { return R"(, {"ty": "tm", )" + members + "}, "; }

double length(const art::Drawing& drawing)
{
    double sum = 0;
    for (const scene::Outline& outline : drawing.outlines)
        sum += art::outline_length(outline);
    return sum;
}

const std::string circle = R"({"ty": "el", "p": {"k": [0, 0]}, "s": {"k": [100, 100]}})";
const std::string rounded = R"({"ty": "rd", "r": {"k": 5}}, )";
constexpr double around = 314.16;

}

TEST_CASE("a trim leaves the piece between two shares of the length")
{
    const art::Drawing drawing = drawing_at(line + trim(R"("s": {"k": 20}, "e": {"k": 70})") + stroke, 0);
    REQUIRE(drawing.outlines.size() == 1);
    CHECK(drawing.outlines[0].from.x == doctest::Approx(20));
    CHECK(drawing.outlines[0].curves.back().to.x == doctest::Approx(70));
}

TEST_CASE("a trim may run either way, and stops at the ends")
{
    const art::Drawing drawing = drawing_at(line + trim(R"("s": {"k": 170}, "e": {"k": 70})") + stroke, 0);
    CHECK(drawing.outlines[0].from.x == doctest::Approx(70));
    CHECK(drawing.outlines[0].curves.back().to.x == doctest::Approx(100));
}

TEST_CASE("past the end of an open path there are two pieces; a closed one goes on")
{
    const std::string offset = R"("e": {"k": 50}, "o": {"k": 270})";
    const art::Drawing open = drawing_at(line + trim(offset) + stroke, 0);
    REQUIRE(open.outlines.size() == 2);
    CHECK(open.outlines[0].from.x == doctest::Approx(75));
    CHECK(open.outlines[1].curves.back().to.x == doctest::Approx(25));
    const std::string again = R"(}, {"ty": "tm", "e": {"k": 50})";
    const art::Drawing first = drawing_at(line + trim(offset + again) + stroke, 0);
    REQUIRE(first.outlines.size() == 1); // half of both is all of the first
    CHECK(length(first) == doctest::Approx(25));
    const art::Drawing closed = drawing_at(circle + trim(offset) + stroke, 0);
    REQUIRE(closed.outlines.size() == 1);
    CHECK_FALSE(closed.outlines[0].closed);
    CHECK(length(closed) == doctest::Approx(around / 2).epsilon(0.001));
    CHECK(closed.outlines[0].from.x == doctest::Approx(-50)); // a quarter before twelve o'clock
}

TEST_CASE("a trim that moves is one of the shape, where all paths of a stroke have it and nothing follows")
{
    const std::string moving = trim(R"("s": {"k": 10}, "e": )" + even("[0]", "[100]"));
    const auto is_trimmed = [](const std::string& shapes) {
        return shape(read_shapes(shapes).nodes.at(0)).trim.has_value();
    };
    const ReadShapes read = read_shapes(circle + moving + stroke);
    const art::Shape& whole = shape(read.nodes.at(0));
    REQUIRE(whole.trim);
    CHECK(whole.drawing.is_still());
    CHECK(whole.trim->start == art::Channel{0.1});
    CHECK(whole.trim->end.keys.size() == 2);
    CHECK_FALSE(whole.trim->together);
    CHECK(is_trimmed(circle + ',' + line + moving + stroke));
    CHECK_FALSE(is_trimmed(circle + moving + line + ", " + stroke));      // one path is whole
    CHECK_FALSE(is_trimmed(circle + moving + moving.substr(2) + stroke)); // trimmed twice
    CHECK_FALSE(is_trimmed(circle + moving + rounded + stroke));          // changed afterwards
    CHECK_FALSE(is_trimmed(circle + trim(R"("e": {"k": 50})") + stroke)); // stands still
}

TEST_CASE("a trim that goes beyond the ends has its keys where it comes to them")
{
    const std::string eased =
        R"({"a": 1, "k": [{"t": 0, "s": [-50], "o": {"x": [0.6], "y": [0]}, "i": {"x": [0.4], "y": [1]}},
                          {"t": 10, "s": [150]}]})";
    const ReadShapes read =
        read_shapes(circle + trim(R"("s": )" + eased + R"(, "e": )" + even("[-100]", "[100]")) + stroke);
    REQUIRE(shape(read.nodes.at(0)).trim);
    const art::Channel& even_one = shape(read.nodes[0]).trim->end;
    REQUIRE(even_one.keys.size() == 3);
    CHECK(even_one.keys[1].time == doctest::Approx(5));
    CHECK(even_one.at(7.5) == doctest::Approx(0.5));
    const art::Channel& start = shape(read.nodes[0]).trim->start;
    REQUIRE(start.keys.size() == 4);
    const art::Ease ease{.kind = art::EaseKind::cubic, .x1 = 0.6, .y1 = 0, .x2 = 0.4, .y2 = 1};
    for (double time = 0; time <= 10; time += 0.25)
        CHECK(start.at(time) ==
              doctest::Approx(std::clamp(2 * art::share_of_way(ease, time / 10) - 0.5, 0.0, 1.0)));
}

TEST_CASE("a trim that moves is right at all times, and draws nothing where nothing is left")
{
    const ReadShapes read =
        read_shapes(circle + trim(R"("s": {"k": 0}, "e": )" + even("[0]", "[100]")) + rounded + stroke);
    const auto& drawing = shape(read.nodes.at(0)).drawing;
    CHECK(drawing.at(0).outlines.empty());
    for (const double time : {0.7, 2.3, 4.9, 5.1, 7.77, 9.9})
        CHECK(length(drawing.at(time)) == doctest::Approx(around * time / 10).epsilon(0.003));
    CHECK(drawing.at(10).outlines[0].closed);
}

TEST_CASE("paths are trimmed each by itself, or as one in their order")
{
    const std::string two = line + ',' + line;
    const art::Drawing each = drawing_at(two + trim(R"("e": {"k": 60})") + stroke, 0);
    REQUIRE(each.outlines.size() == 2);
    CHECK(length(each) == doctest::Approx(120));
    const art::Drawing as_one = drawing_at(two + trim(R"("m": 2, "e": {"k": 60})") + stroke, 0);
    REQUIRE(as_one.outlines.size() == 2);
    CHECK(as_one.outlines[0].curves.back().to.x == doctest::Approx(100));
    CHECK(as_one.outlines[1].curves.back().to.x == doctest::Approx(20));
}

TEST_CASE("trims of what is trimmed are of what is left")
{
    const std::string another = R"(}, {"ty": "tm", )";
    const ReadShapes read =
        read_shapes(circle +
                    trim(R"("s": {"k": 25}, "e": {"k": 75})" + another + R"("s": {"k": 50}, "e": )" +
                         even("[99]", "[100]") + another + R"("s": {"k": 0}, "e": )" + even("[0]", "[100]")) +
                    stroke);
    const auto& drawing = shape(read.nodes.at(0)).drawing;
    for (const double time : {0.7, 2.3, 4.9, 9.9})
        CHECK(length(drawing.at(time)) ==
              doctest::Approx(around / 2 * (0.49 + time / 1000) * time / 10).epsilon(0.003));
}

TEST_CASE("a trim behind a style and a group changes the paths before it")
{
    const std::string group = R"({"ty": "gr", "it": [)" + line + ',' + stroke + R"(, {"ty": "tr"}]})";
    const ReadShapes read = read_shapes(group + R"(, {"ty": "tm", "e": {"k": 50}})");
    CHECK(length(shape(read.nodes.at(0)).drawing.value()) == doctest::Approx(50));
}

TEST_CASE("corners without tangents are rounded, but not the ends of a path")
{
    const art::Drawing drawing = drawing_at(square + R"(, {"ty": "rd", "r": {"k": 2}}, )" + red, 0);
    REQUIRE(drawing.outlines[0].curves.size() == 8);
    CHECK(length(drawing) == doctest::Approx(28 - 16 + around / 25).epsilon(0.001));
    const art::Drawing open = drawing_at(line + R"(, {"ty": "rd", "r": {"k": 2}}, )" + stroke, 0);
    CHECK(open.outlines[0].curves.size() == 1);
}

namespace {

/// A line with these members of "d".
std::string dashed_line(const std::string& dashes)
{
    return line + R"(, {"ty": "st", "c": {"k": [0, 1, 0, 1]}, "w": {"k": 2}, "d": [)" + dashes + "]}";
}

std::string dash(const std::string& name, const std::string& value)
{
    return R"({"n": ")" + name + R"(", "v": )" + value + "}";
}

/// As many lengths as no scene has, one after the other.
std::string eight(const std::string& dash_length, const std::string& gap)
{
    std::string lengths;
    for (int i = 0; i < 4; ++i)
        lengths += (i == 0 ? "" : ", ") + dash("d", dash_length) + ", " + dash("g", gap);
    return lengths;
}

}

TEST_CASE("dashes are those of the line, still or moving")
{
    const std::string pattern = dash("d", R"({"k": 20})") + ", " + dash("g", R"({"k": 10})") + ", ";
    const ReadShapes read = read_shapes(dashed_line(pattern + dash("o", even("[0]", "[-60]"))));
    const art::Shape& it = shape(read.nodes.at(0));
    CHECK(it.drawing.is_still());
    CHECK(it.drawing.value().outlines.size() == 1);
    REQUIRE(it.stroke->dashes.lengths.size() == 2);
    CHECK(it.stroke->dashes.lengths[0].value() == 20);
    CHECK(it.stroke->dashes.lengths[1].value() == 10);
    CHECK(it.stroke->dashes.offset.at(2.5) == doctest::Approx(-15));
    const ReadShapes solid =
        read_shapes(dashed_line(dash("d", R"({"k": 20})") + ", " + dash("g", R"({"k": 0})")));
    CHECK(shape(solid.nodes.at(0)).stroke->dashes.lengths.empty());
}

TEST_CASE("what is trimmed is dashed, too")
{
    const ReadShapes read = read_shapes(line + trim(R"("e": )" + even("[0]", "[100]")) +
                                        dashed_line(dash("d", R"({"k": 20})")).substr(line.size() + 2));
    REQUIRE(read.nodes.size() == 1);
    CHECK(shape(read.nodes[0]).trim);
    CHECK(shape(read.nodes[0]).stroke->dashes.lengths.size() == 1);
}

TEST_CASE("dashes that scenes do not have are pieces of the line, and begin the pattern at the offset")
{
    const std::string lengths = eight(R"({"k": 20})", R"({"k": 10})") + ", ";
    const art::Drawing still = drawing_at(dashed_line(lengths + dash("o", R"({"k": 5})")), 0);
    REQUIRE(still.outlines.size() == 4);
    CHECK(still.outlines[0].from.x == doctest::Approx(0));
    CHECK(still.outlines[0].curves[0].to.x == doctest::Approx(15));
    CHECK(still.outlines[3].from.x == doctest::Approx(85));
    CHECK(still.outlines[3].curves[0].to.x == doctest::Approx(100));
    const art::Drawing moving = drawing_at(dashed_line(lengths + dash("o", even("[0]", "[-60]"))), 2.5);
    CHECK(moving.outlines[0].from.x == doctest::Approx(0));
    CHECK(moving.outlines[0].curves[0].to.x == doctest::Approx(5));
    CHECK(moving.outlines[1].from.x == doctest::Approx(15));
}

TEST_CASE("dashes without length are dots, and too many dashes are one line")
{
    const art::Drawing few = drawing_at(dashed_line(eight(R"({"k": 0})", R"({"k": 40})")), 0);
    REQUIRE(few.outlines.size() == 3);
    CHECK(few.outlines[1].from.x == doctest::Approx(40));
    const ReadShapes many =
        read_shapes(dashed_line(dash("d", R"({"k": 0})") + ", " + dash("g", R"({"k": 0.01})")));
    CHECK(shape(many.nodes[0]).drawing.value().outlines.size() == 1);
    REQUIRE(many.losses.list().size() == 1);
    CHECK(many.losses.list()[0].feature == "too many dashes");
}

TEST_CASE("dashes that are too fine for a moment are those of the scene")
{
    const std::string growing = even("[0.02]", "[20]");
    const ReadShapes read = read_shapes(dashed_line(dash("d", growing) + ", " + dash("g", growing)));
    CHECK(read.losses.empty());
    CHECK(shape(read.nodes.at(0)).stroke->dashes.lengths.size() == 2);
}

TEST_CASE("too many dashes to move stand still")
{
    const std::string lengths = eight(R"({"k": 0.25})", R"({"k": 0.25})") + ", ";
    const ReadShapes read = read_shapes(dashed_line(lengths + dash("o", even("[0]", "[9]"))));
    CHECK(shape(read.nodes.at(0)).drawing.is_still());
    CHECK(shape(read.nodes[0]).drawing.value().outlines.size() == 200);
    REQUIRE(read.losses.list().size() == 1);
    CHECK(read.losses.list()[0].feature == "more than 120 moving dashes");
}

TEST_CASE("a repeater of nothing left, or endlessly much, has numbers that can be drawn")
{
    const ReadShapes read =
        read_shapes(square + ',' + red +
                    R"(, {"ty": "rp", "c": {"k": 3}, "o": {"k": -1.5}, "tr": {"s": {"k": [0, 1e9]}}})");
    REQUIRE(read.nodes.size() == 3);
    for (const art::Node& node : read.nodes) {
        CHECK(std::abs(node.transform.scale_x.value()) <= 1e6);
        CHECK(std::abs(node.transform.scale_y.value()) <= 1e6);
    }
}

TEST_CASE("a repeater paints copies, each a step further, the first on top unless it says otherwise")
{
    const std::string repeater =
        R"(, {"ty": "rp", "c": {"k": 3}, "o": {"k": 0}, "m": 1, "tr": {"p": {"k": [10, 0]}, "r": {"k": 30}, "s": {"k": [50, 50]}, "so": {"k": 100}, "eo": {"k": 0}}})";
    const ReadShapes read = read_shapes(square + ',' + red + repeater);
    REQUIRE(read.nodes.size() == 3);
    CHECK(read.nodes[2].transform == art::Transform{});
    CHECK(read.nodes[1].transform.x.value() == 10);
    CHECK(read.nodes[0].transform.x.value() == 20);
    CHECK(read.nodes[0].transform.rotate.value() == 60);
    CHECK(read.nodes[0].transform.scale_x.value() == 0.25);
    CHECK(read.nodes[1].opacity.value() == 0.5);
}

TEST_CASE("a style behind a repeater paints all copies as one")
{
    const ReadShapes read =
        read_shapes(square + R"(, {"ty": "rp", "c": {"k": 4}, "tr": {"p": {"k": [10, 0]}}}, )" + red);
    REQUIRE(read.nodes.size() == 1);
    CHECK(shape(read.nodes[0]).drawing.value().outlines.size() == 4);
}

TEST_CASE("copies come and go with their number")
{
    const ReadShapes read =
        read_shapes(square + ',' + red + R"(, {"ty": "rp", "c": )" + even("[1]", "[3]") + R"(, "tr": {}})");
    REQUIRE(read.nodes.size() == 3);
    CHECK(read.nodes[2].shown == std::vector<art::Span>{{}});
    CHECK(read.nodes[0].shown[0].from == doctest::Approx(5).epsilon(0.001));
}

TEST_CASE("stars have their tips and dents where they are told, also turned round")
{
    const std::string star =
        R"({"ty": "sr", "sy": 1, "p": {"k": [0, 0]}, "pt": {"k": 5}, "or": {"k": 40}, "ir": {"k": 20}, "os": {"k": 0}, "is": {"k": 0}, "r": {"k": 90})";
    const auto outline = drawing_at(star + "}, " + red, 0).outlines.at(0);
    CHECK(outline.curves.size() == 10);
    CHECK(outline.from.x == doctest::Approx(40));
    CHECK(outline.curves[0].to.y == doctest::Approx(20 * 0.587785));
    const auto reversed = drawing_at(star + R"(, "d": 3}, )" + red, 0).outlines.at(0);
    CHECK(reversed.curves[0].to.y == doctest::Approx(-20 * 0.587785));
}
