#include "host/lottie/drawings/extent.hpp"
#include "tests/host/lottie/lottie_text.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::lottie;

namespace {

std::string rectangle(double left, double top, double right, double bottom)
{
    const auto spot = [](double x, double y) {
        return "[" + std::to_string(x) + ", " + std::to_string(y) + "]";
    };
    return R"({"k": {"c": true, "v": [)" + spot(left, top) + "," + spot(right, top) + "," +
           spot(right, bottom) + "," + spot(left, bottom) +
           R"(], "i": [[0,0],[0,0],[0,0],[0,0]], "o": [[0,0],[0,0],[0,0],[0,0]]}})";
}

std::string mask(const std::string& path, const std::string& more = "", const char* mode = "a")
{
    return R"({"pt": )" + path + ", " + more + R"("mode": ")" + mode + "\"}";
}

/// A box of 20 by 10 pixels that moves, with masks.
std::string masked(const std::string& masks)
{
    return solid(
        R"("ks": {"p": {"k": [{"t": 0, "s": [0, 0]}, {"t": 60, "s": [50, 50]}]}}, "masksProperties": [)" +
        masks + "], ");
}

const std::string around = rectangle(-1, -1, 21, 11);
const std::string away = rectangle(30, 0, 40, 10);
const std::string inside = rectangle(5, 2, 15, 8);

/// How many figures are drawn.
std::size_t drawn(const std::string& masks)
{
    const art::Document document = read_whole(animation_text(masked(masks)));
    return document.nodes.empty() ? 0 : group_of(document.nodes[0]).nodes.size();
}

art::Shape cut(const std::string& masks)
{
    return shape_of(group_of(read_whole(animation_text(masked(masks))).nodes.at(0)).nodes.at(0));
}

/// Left, top, right and bottom of its points, rounded.
std::string extent(const art::Drawing& drawing)
{
    Box box;
    for (const scene::Outline& outline : drawing.outlines) {
        box.include(outline.from);
        for (const scene::Curve& curve : outline.curves)
            box.include(curve.to);
    }
    const auto number = [](double value) { return std::to_string(std::lround(value)); };
    return number(box.left) + ' ' + number(box.top) + ' ' + number(box.right) + ' ' + number(box.bottom);
}

/// Of a square of 10 by 10 pixels whose middle moves in 40 frames.
art::Animated<art::Drawing> moving_behind(const std::string& path, const std::string& from,
                                          const std::string& to)
{
    const std::string shapes =
        R"("shapes": [{"ty": "rc", "s": {"k": [10, 10]}, "p": {"a": 1, "k": [{"t": 0, "s": [)" + from +
        R"(]}, {"t": 40, "s": [)" + to + R"(]}]}}, {"ty": "fl", "c": {"k": [1, 0, 0]}}])";
    const art::Document document = read_whole(animation_text(
        R"({"ty": 4, "ip": 0, "op": 60, "masksProperties": [)" + mask(path) + "], " + shapes + "}"));
    return shape_of(group_of(document.nodes.at(0)).nodes.at(0)).drawing;
}

bool is_lost(const std::string& text, const char* feature)
{
    art::Losses losses;
    read_with(text, losses);
    return losses.list().size() == 1 && losses.list()[0].feature == feature;
}

}

TEST_CASE("a mask around all that is drawn changes nothing, one beside it hides all")
{
    CHECK(drawn(mask(around)) == 1);
    CHECK(drawn(mask(away)) == 0);
    CHECK(drawn(mask(around, R"("inv": true, )")) == 0);
    CHECK(drawn(mask(away, R"("inv": true, )")) == 1);
    CHECK(drawn(mask(away, "", "s")) == 1);
    CHECK(drawn(mask(around, "", "s")) == 0);
    CHECK(drawn(mask(around, "", "i")) == 1);
    CHECK(drawn(mask(away, "", "n")) == 1);
    CHECK(drawn(mask(around) + "," + mask(around, "", "s")) == 0);
    CHECK(drawn(mask(away) + "," + mask(around)) == 1);
    CHECK(drawn(mask(around) + "," + mask(away, "", "i")) == 0);
    CHECK(drawn(mask(around) + "," + mask(away, "", "f")) == 1);
}

TEST_CASE("a solid takes the shape of a mask within it")
{
    const art::Shape shaped = cut(mask(inside, R"("o": {"k": 40}, )"));
    REQUIRE(shaped.drawing.value().outlines.size() == 1);
    CHECK(shaped.drawing.value().outlines[0].from.x == 5);
    CHECK(shaped.fill->opacity.value() == 0.4);
    const art::Shape pierced = cut(mask(inside, R"("inv": true, )"));
    CHECK(pierced.drawing.value().outlines.size() == 2);
    CHECK(pierced.fill->rule == FillRule::even_odd);
    CHECK(cut(mask(inside, "", "s")).drawing.value().outlines.size() == 2);
    CHECK(drawn(mask(inside) + "," + mask(rectangle(1, 1, 4, 4))) == 2);
    CHECK(cut(mask(inside, "", "f")).drawing.value().outlines.size() == 1);
}

TEST_CASE("what is filled is cut to a convex mask, and a box to any")
{
    const art::Shape corner = cut(mask(rectangle(5, 5, 40, 40)));
    CHECK(corner.drawing.is_still());
    CHECK(extent(corner.drawing.value()) == "5 5 20 10");
    CHECK(extent(cut(mask(inside, "", "i")).drawing.value()) == "5 2 15 8");
    CHECK(extent(cut(mask(rectangle(-5, 1, 12, 20)) + "," + mask(rectangle(6, 0, 40, 40), "", "i"))
                     .drawing.value()) == "6 1 12 10");
    const std::string arrow = R"({"k": {"c": true, "v": [[2,-9],[30,5],[2,19],[10,5]],
        "i": [[0,0],[0,0],[0,0],[0,0]], "o": [[0,0],[0,0],[0,0],[0,0]]}})";
    CHECK(extent(cut(mask(arrow)).drawing.value()) == "7 0 20 10");
}

TEST_CASE("what a mask leaves of something that moves changes, and is empty while it is beyond")
{
    const art::Animated<art::Drawing> drawing = moving_behind(rectangle(0, 0, 60, 60), "-20, 5", "20, 5");
    CHECK(drawing.at(10).outlines.empty());
    CHECK(extent(drawing.at(18)) == "0 0 3 10");
    CHECK(extent(drawing.at(20)) == "0 0 5 10");
    CHECK(extent(drawing.at(30)) == "5 0 15 10");
}

TEST_CASE("what passes a mask between two looks at it is seen there")
{
    const art::Animated<art::Drawing> drawing = moving_behind(rectangle(-5, 0, 5, 10), "-200, 5", "200, 5");
    CHECK(drawing.at(18).outlines.empty());
    CHECK(extent(drawing.at(20)) == "-5 0 5 10");
    CHECK(drawing.at(22).outlines.empty());
}

TEST_CASE("where too much moves behind a mask, nothing that moves is cut")
{
    std::string shapes;
    for (int i = 0; i < 400; ++i)
        shapes += R"({"ty": "gr", "it": [{"ty": "el", "s": {"k": [10, 10]}, "p": {"a": 1, "k":
            [{"t": 0, "s": [-20, 5]}, {"t": 40, "s": [20, 5]}]}}, {"ty": "fl", "c": {"k": [1, 0, 0]}}]},)";
    shapes.pop_back();
    art::Losses losses;
    const art::Document document =
        read_with(animation_text(R"({"ty": 4, "ip": 0, "op": 60, "masksProperties": [)" +
                                 mask(rectangle(0, 0, 60, 60)) + R"(], "shapes": [)" + shapes + "]}"),
                  losses);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].instead == "what reaches beyond it is seen");
    for (const art::Node& node : group_of(document.nodes.at(0)).nodes)
        CHECK(shape_of(node).drawing.keys.size() == 2);
}

TEST_CASE("other masks are reported")
{
    const char* const cutting = "masks that cut each other, or grow";
    CHECK(is_lost(animation_text(masked(mask(around, R"("x": {"k": 3}, )"))), cutting));
    CHECK(is_lost(animation_text(masked(mask(around) + "," + mask(inside, "", "s"))), cutting));
    CHECK(is_lost(animation_text(masked(mask(inside) + "," + mask(inside, "", "f"))), cutting));
    CHECK(is_lost(animation_text(masked(mask(rectangle(5, 5, 40, 40), "", "s"))), "mask"));
}

TEST_CASE("a matte that covers the layer changes nothing, its opposite hides it, and it is not drawn itself")
{
    const auto with = [](const char* mode, const std::string& matte) {
        return animation_text(matte + "," + solid(std::string{R"("tt": )"} + mode + ", "));
    };
    const std::string white =
        R"({"ty": 1, "td": 1, "nm": "matte", "sw": 90, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 60})";
    const std::string black =
        R"({"ty": 1, "td": 1, "nm": "matte", "sw": 90, "sh": 70, "sc": "#000000", "ip": 0, "op": 60})";
    CHECK(read_whole(with("1", white)).nodes.size() == 1);
    CHECK(read_whole(with("1", white)).nodes.at(0).name == "box");
    CHECK(read_whole(with("2", white)).nodes.empty());
    CHECK(read_whole(with("3", white)).nodes.size() == 1);
    CHECK(read_whole(with("4", white)).nodes.empty());
    CHECK(read_whole(with("1", black)).nodes.size() == 1);
    CHECK(read_whole(with("3", black)).nodes.empty());
    CHECK(read_whole(with("4", black)).nodes.size() == 1);
    const std::string small =
        R"({"ty": 1, "td": 1, "nm": "matte", "sw": 10, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 60})";
    const art::Document cut_by_small = read_whole(with("1", small));
    CHECK(extent(shape_of(group_of(cut_by_small.nodes.at(0)).nodes.at(0)).drawing.value()) == "0 0 10 10");
    CHECK(is_lost(with("2", small), "matte"));
    const std::string brief =
        R"({"ty": 1, "td": 1, "nm": "matte", "sw": 90, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 30})";
    CHECK(is_lost(with("1", brief), "matte"));
    const std::string faint = R"({"ty": 1, "td": 1, "sw": 90, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 60,
        "ks": {"o": {"k": 50}}})";
    CHECK(is_lost(with("1", faint), "matte"));
}

TEST_CASE("a matte cuts where it and the layer have moved to")
{
    const std::string matte = R"({"ty": 1, "td": 1, "nm": "matte", "sw": 10, "sh": 70, "sc": "#ffffff",
        "ip": 0, "op": 60, "ks": {"p": {"a": 1, "k": [{"t": 0, "s": [0, 0]}, {"t": 40, "s": [40, 0]}]}}},)";
    const art::Document document =
        read_whole(animation_text(matte + solid(R"("tt": 1, "ks": {"p": {"k": [5, 0]}}, )")));
    const auto& drawing = shape_of(group_of(document.nodes.at(0)).nodes.at(0)).drawing;
    CHECK(extent(drawing.at(0)) == "0 0 5 10");
    CHECK(extent(drawing.at(10)) == "5 0 15 10");
    CHECK(drawing.at(30).outlines.empty());
}

TEST_CASE("a matte may be named by its number")
{
    const std::string text = animation_text(
        solid(R"("tt": 2, "tp": 7, )") + "," + solid("", "between") +
        R"(,{"ty": 1, "ind": 7, "td": 1, "sw": 90, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 60})");
    const art::Document document = read_whole(text);
    REQUIRE(document.nodes.size() == 1);
    CHECK(document.nodes[0].name == "between");
    CHECK(is_lost(animation_text(solid(R"("tt": 1, "tp": 9, )")), "matte"));
}
