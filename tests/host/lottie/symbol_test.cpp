#include "tests/host/lottie/lottie_text.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace kfast;
using namespace kfast::lottie;

namespace {

const std::string turning_box =
    R"({"ty": 1, "nm": "box", "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60,
    "ks": {"r": {"k": [{"t": 0, "s": 0}, {"t": 30, "s": 90}]}}})";

std::string comp(const std::string& more)
{
    return R"({"ty": 0, "nm": "comp", "refId": "c", "w": 100, "h": 80, )" + more + "}";
}

art::Document read(const std::string& layers, const std::string& inner = turning_box)
{
    return read_whole(animation_text(layers, R"("assets": [{"id": "c", "layers": [)" + inner + "]}], "));
}

const art::Use& use_of(const art::Node& node)
{
    REQUIRE(std::holds_alternative<art::Use>(node.content));
    return std::get<art::Use>(node.content);
}

const art::Use& use_in(const art::Node& layer) { return use_of(group_of(layer).nodes.at(0)); }

std::string remapped(const std::string& keys, const std::string& loop)
{
    return comp(R"("ip": 0, "op": 60, "tm": {"k": [)" + keys + R"(], "x": "$bm_rt = )" + loop + R"(;"})");
}

const std::string second = R"({"t": 5, "s": [0]}, {"t": 20, "s": [0.5]})";
const std::string back = R"({"t": 5, "s": [0.5]}, {"t": 20, "s": [0]})";

std::string shapes(const std::string& repeater)
{
    return R"({"ty": 4, "nm": "dots", "ip": 0, "op": 60, "shapes": [{"ty": "el", "p": {"k": [5, 0]},
        "s": {"k": [4, 4]}}, {"ty": "fl", "c": {"k": [1, 0, 0]}}, {"ty": "rp", )" +
           repeater + "}]}";
}

std::vector<art::Node> copies_of(const std::string& repeater)
{
    return group_of(read_whole(animation_text(shapes(repeater))).nodes.at(0)).nodes;
}

void check_copies(const std::vector<art::Node>& nodes, const std::string& repeater)
{
    const art::Document written = read_written_out(animation_text(shapes(repeater)));
    const std::vector<art::Node>& groups = group_of(written.nodes.at(0)).nodes;
    const art::Document document = read_whole(animation_text(shapes(repeater)));
    const art::Node& content = document.symbols.at(0).nodes.at(0);
    const art::Copies& copies = use_of(nodes.at(0)).copies;
    REQUIRE(groups.size() == static_cast<std::size_t>(copies.count));
    for (int i = 0; i < copies.count; ++i) {
        const art::Affine copy =
            matrix_at(nodes[0].transform, 0) * matrix_of(copies, i) * matrix_at(content.transform, 0);
        const art::Affine group = matrix_at(groups[static_cast<std::size_t>(i)].transform, 0);
        const scene::Vec2 spot{30, -20};
        CHECK(distance(copy.of(spot), group.of(spot)) < 1e-9);
        CHECK(groups[static_cast<std::size_t>(i)].opacity.value() == doctest::Approx(1 + i * copies.opacity));
    }
}

}

TEST_CASE("a composition that is used several times is a symbol, whose uses have their own delay and speed")
{
    const art::Document document =
        read(comp(R"("ip": 0, "op": 60)") + "," + comp(R"("ip": 10, "op": 60, "st": 10)") + "," +
             comp(R"("ip": 0, "op": 60, "sr": 2)") + "," + comp(R"("ip": 0, "op": 60, "st": 60, "sr": -1)"));
    REQUIRE(document.symbols.size() == 1);
    CHECK(document.symbols[0].name == "comp");
    CHECK(document.symbols[0].nodes.at(0).transform.rotate.keys.back().time == 30);
    // The lowest is read first, and the symbol has its frames.
    CHECK(use_in(document.nodes[3]) == art::Use{});
    CHECK(use_in(document.nodes[2]) == art::Use{.delay = 10});
    CHECK(use_in(document.nodes[1]) == art::Use{.speed = 0.5});
    CHECK(use_in(document.nodes[0]) == art::Use{.speed = -1});
    CHECK(document.nodes[2].shown == std::vector<art::Span>{{.from = 10}});
    CHECK(document.symbols[0].loop == Loop::once);
    CHECK(document.symbols[0].frames == 60);
}

TEST_CASE("a composition that is used once is written where it is used")
{
    CHECK(read(comp(R"("ip": 0, "op": 60, "st": 10)")).symbols.empty());
}

TEST_CASE("time that goes evenly again and again is the loop of a symbol")
{
    const art::Document cycle = read(remapped(second, "loopOut('cycle')"));
    REQUIRE(cycle.symbols.size() == 1);
    CHECK(cycle.symbols[0].loop == Loop::repeat);
    CHECK(cycle.symbols[0].frames == 15);
    CHECK(use_in(cycle.nodes[0]) == art::Use{.delay = 5});
    const art::Document forth_and_back = read(remapped(second, "loopOut('pingpong')"));
    CHECK(forth_and_back.symbols.at(0).loop == Loop::ping_pong);
    const art::Document back_and_forth = read(remapped(back, "loopOut('pingpong')"));
    CHECK(use_in(back_and_forth.nodes[0]) == art::Use{.delay = 5, .speed = -1});
    const art::Document before =
        read(remapped(R"({"t": 50, "s": [0]}, {"t": 60, "s": [0.5]})", "loopIn('cycle')"));
    CHECK(use_in(before.nodes[0]).delay == -10);
}

TEST_CASE("other loops are written out")
{
    CHECK(read(remapped(back, "loopOut('cycle')")).symbols.empty());
    CHECK(read(remapped(second, "loopIn('cycle')")).symbols.empty());
    CHECK(
        read(remapped(R"({"t": 0, "s": [0]}, {"t": 10, "s": [1]}, {"t": 20, "s": [0]})", "loopOut('cycle')"))
            .symbols.empty());
    CHECK(read(remapped(R"({"t": 0, "s": [0], "o": {"x": [0.5], "y": [0]}, "i": {"x": [0.5], "y": [1]}},
                           {"t": 10, "s": [1]})",
                        "loopOut('cycle')"))
              .symbols.empty());
    CHECK(read(remapped(R"({"t": 0, "s": [0]}, {"t": 100, "s": [1]})", "loopOut('cycle')")).symbols.empty());
}

TEST_CASE("a layer that cuts its composition has it written out")
{
    const std::string mask =
        R"(, "masksProperties": [{"mode": "a", "pt": {"k": {"c": true, "v": [[0, 0], [9, 0], [9, 9]],
           "i": [[0, 0], [0, 0], [0, 0]], "o": [[0, 0], [0, 0], [0, 0]]}}, "o": {"k": 100}}])";
    const art::Document document =
        read(comp(R"("ip": 0, "op": 60)") + "," + comp(R"("ip": 0, "op": 60)" + mask));
    CHECK(document.symbols.size() == 1);
    CHECK(std::holds_alternative<art::Shape>(
        group_of(group_of(document.nodes[0]).nodes.at(0)).nodes.at(0).content));
    CHECK(use_in(document.nodes[1]) == art::Use{});
}

TEST_CASE("a composition that is seen beyond its edges is written out")
{
    const std::string aside = R"("ip": 0, "op": 60, "ks": {"p": {"k": [-20, 0]}})";
    const std::string wide =
        R"({"ty": 1, "nm": "box", "sw": 200, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60})";
    const art::Document document = read(comp(aside) + "," + comp(aside), wide);
    CHECK(std::holds_alternative<art::Group>(group_of(document.nodes.at(0)).nodes.at(0).content));
}

TEST_CASE("a composition with mattes is written out, as these depend on where it is")
{
    const std::string matted =
        R"({"ty": 1, "nm": "matte", "td": 1, "sw": 90, "sh": 90, "sc": "#ffffff", "ip": 0,
        "op": 60}, {"ty": 1, "nm": "box", "tt": 1, "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60})";
    CHECK(read(comp(R"("ip": 0, "op": 60)") + "," + comp(R"("ip": 0, "op": 60)"), matted).symbols.empty());
}

TEST_CASE("the copies of a repeater that stands still are one use of a symbol")
{
    for (const char* repeater :
         {R"("c": {"k": 5}, "tr": {"p": {"k": [12, 3]}})",
          R"("c": {"k": 5}, "m": 2, "tr": {"p": {"k": [12, 3]}, "r": {"k": 30}, "a": {"k": [4, 6]}})",
          R"("c": {"k": 5}, "m": 1, "tr": {"p": {"k": [12, 3]}, "r": {"k": 200}, "a": {"k": [4, 6]}})",
          R"("c": {"k": 6}, "m": 1, "o": {"k": 1.5},
             "tr": {"p": {"k": [12, 3]}, "r": {"k": 30}, "s": {"k": [120, 120]}, "a": {"k": [4, 6]}})",
          R"("c": {"k": 6}, "m": 2, "o": {"k": -2}, "tr": {"p": {"k": [12, 3]}, "r": {"k": -30}})",
          R"("c": {"k": 6}, "m": 2, "o": {"k": 1.5}, "tr": {"p": {"k": [12, 3]}, "s": {"k": [80, 80]}})",
          R"("c": {"k": 5}, "m": 2, "tr": {"p": {"k": [12, 3]}, "so": {"k": 100}, "eo": {"k": 20}})",
          R"("c": {"k": 5}, "m": 1, "tr": {"p": {"k": [12, 3]}, "so": {"k": 20}, "eo": {"k": 100}})"}) {
        CAPTURE(repeater);
        check_copies(copies_of(repeater), repeater);
    }
}

TEST_CASE("copies that are no even steps are groups")
{
    for (const char* repeater :
         {R"("c": {"k": 2}, "tr": {"p": {"k": [12, 3]}})",
          R"("c": {"k": 5}, "tr": {"p": {"k": [12, 3]}, "s": {"k": [80, 90]}})",
          R"("c": {"k": 5}, "tr": {"p": {"k": [12, 3]}, "s": {"k": [-90, -90]}})",
          R"("c": {"k": 5}, "tr": {"p": {"k": [12, 3]}, "so": {"k": 50}, "eo": {"k": 20}})",
          R"("c": {"k": 5}, "o": {"k": -0.5}, "tr": {"s": {"k": [80, 80]}})",
          R"("c": {"k": 30}, "tr": {"s": {"k": [150, 150]}})",
          R"("c": {"k": 5}, "tr": {"r": {"k": [{"t": 0, "s": [0]}, {"t": 30, "s": [90]}]}})",
          R"("c": {"k": [{"t": 0, "s": [1]}, {"t": 30, "s": [9]}]}, "tr": {"p": {"k": [12, 3]}})"}) {
        CAPTURE(repeater);
        CHECK(read_whole(animation_text(shapes(repeater))).symbols.empty());
    }
}

TEST_CASE("copies that a later modifier changes are groups")
{
    const std::string layer =
        R"({"ty": 4, "nm": "dots", "ip": 0, "op": 60, "shapes": [{"ty": "el", "p": {"k": [5, 0]},
        "s": {"k": [4, 4]}}, {"ty": "st", "c": {"k": [1, 0, 0]}, "w": {"k": 1}},
        {"ty": "rp", "c": {"k": 5}, "tr": {"p": {"k": [12, 3]}}}, {"ty": "tm", "s": {"k": 0}, "e": {"k": 50}, "m": 2}]})";
    CHECK(read_whole(animation_text(layer)).symbols.empty());
}

TEST_CASE("repeaters of repeaters are copies of copies")
{
    const std::string step =
        R"("c": {"k": 3}, "tr": {"p": {"k": [12, 3]}}}, {"ty": "rp", "c": {"k": 4}, "tr": {"p": {"k": [0, 9]}})";
    const art::Document document = read_whole(animation_text(shapes(step)));
    REQUIRE(document.symbols.size() == 2);
    CHECK(use_of(group_of(document.nodes.at(0)).nodes.at(0)).copies.count == 4);
    CHECK(use_of(group_of(document.symbols[1].nodes.at(0)).nodes.at(0)).copies.count == 3);
}
