#include "tests/host/lottie/lottie_text.hpp"

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

art::Figure cut(const std::string& masks)
{
    return figure_of(group_of(read_whole(animation_text(masked(masks))).nodes.at(0)).nodes.at(0));
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
    const art::Figure shaped = cut(mask(inside, R"("o": {"k": 40}, )"));
    REQUIRE(shaped.drawing.value().outlines.size() == 1);
    CHECK(shaped.drawing.value().outlines[0].from.x == 5);
    CHECK(shaped.fill->opacity.value() == 0.4);
    const art::Figure pierced = cut(mask(inside, R"("inv": true, )"));
    CHECK(pierced.drawing.value().outlines.size() == 2);
    CHECK(pierced.fill->rule == FillRule::even_odd);
    CHECK(cut(mask(inside, "", "s")).drawing.value().outlines.size() == 2);
    CHECK(drawn(mask(inside) + "," + mask(rectangle(1, 1, 4, 4))) == 2);
    CHECK(cut(mask(inside, "", "f")).drawing.value().outlines.size() == 1);
}

TEST_CASE("other masks are reported")
{
    const char* const cutting = "masks that cut each other, or grow";
    CHECK(is_lost(animation_text(masked(mask(rectangle(5, 5, 40, 40)))), cutting));
    CHECK(is_lost(animation_text(masked(mask(around, R"("x": {"k": 3}, )"))), cutting));
    CHECK(is_lost(animation_text(masked(mask(around) + "," + mask(inside, "", "s"))), cutting));
    CHECK(is_lost(animation_text(masked(mask(inside) + "," + mask(inside, "", "f"))), cutting));
    CHECK(is_lost(animation_text(masked(mask(inside, "", "i"))), "mask"));
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
    CHECK(is_lost(with("1", small), "matte"));
    const std::string brief =
        R"({"ty": 1, "td": 1, "nm": "matte", "sw": 90, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 30})";
    CHECK(is_lost(with("1", brief), "matte"));
    const std::string faint = R"({"ty": 1, "td": 1, "sw": 90, "sh": 70, "sc": "#ffffff", "ip": 0, "op": 60,
        "ks": {"o": {"k": 50}}})";
    CHECK(is_lost(with("1", faint), "matte"));
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
