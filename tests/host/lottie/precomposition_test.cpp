#include "tests/host/lottie/lottie_text.hpp"

#include "host/lottie/drawings/extent.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::lottie;

namespace {

/// Turns from 0 to 90 degrees in the frames 0 to 30, and is seen in the frames 5 to 40.
const char* const turning = R"({"ty": 1, "nm": "box", "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 5, "op": 40,
    "ks": {"r": {"k": [{"t": 0, "s": 0}, {"t": 30, "s": 90}]}}})";

std::string with_assets(const std::string& layers, const std::string& inner)
{
    return animation_text(layers, R"("assets": [{"id": "c", "layers": [)" + inner + "]}], ");
}

std::string precomposition(const std::string& more)
{
    return R"({"ty": 0, "nm": "comp", "refId": "c", "w": 100, "h": 80, "ip": 0, "op": 60, )" + more +
           R"("st": 0})";
}

art::Node content(const std::string& more, const std::string& inner = turning)
{
    return group_of(read_whole(with_assets(precomposition(more), inner)).nodes.at(0)).nodes.at(0);
}

}

TEST_CASE("a precomposition is a group, and starts and stretches what is inside")
{
    const std::string layer =
        R"({"ty": 0, "nm": "comp", "refId": "c", "w": 100, "h": 80, "ip": 0, "op": 60, "st": 10, "sr": 0.5})";
    const art::Document document = read_whole(with_assets(layer, turning));
    CHECK(document.nodes.at(0).name == "comp");
    const art::Node& box = group_of(document.nodes[0]).nodes.at(0);
    CHECK(box.name == "box");
    CHECK(box.transform.rotate.keys[0].time == 10);
    CHECK(box.transform.rotate.keys[1].time == 25);
    CHECK(box.shown == std::vector<art::Span>{{12.5, 30}});
}

TEST_CASE("times of precompositions in each other multiply")
{
    const std::string text = animation_text(
        R"({"ty": 0, "refId": "a", "ip": 0, "op": 60, "st": 4, "sr": 2})",
        R"("assets": [{"id": "a", "layers": [{"ty": 0, "refId": "b", "ip": 0, "op": 60, "st": 3, "sr": 3}]},
                      {"id": "b", "layers": [)" +
            std::string{turning} + "]}], ");
    const art::Document document = read_whole(text);
    const art::Node& box = group_of(group_of(document.nodes.at(0)).nodes.at(0)).nodes.at(0);
    CHECK(box.transform.rotate.keys[0].time == 4 + 2 * 3);
    CHECK(box.transform.rotate.keys[1].time == 4 + 2 * (3 + 3 * 30));
}

TEST_CASE("a composition that is written twice has parents of its own each time")
{
    const std::string inner = solid(R"("ind": 1, "parent": 2, )") + R"(,{"ty": 3, "ind": 2})";
    const art::Document document =
        read_written_out(with_assets(precomposition("") + "," + precomposition(""), inner));
    CHECK(group_of(document.nodes.at(0)).nodes.at(0).parent_tag !=
          group_of(document.nodes.at(1)).nodes.at(0).parent_tag);
}

TEST_CASE("a remapping that is one even way is a stretch, also backwards")
{
    const art::Node forth = content(R"("tm": {"k": [{"t": 0, "s": [0]}, {"t": 60, "s": [1]}]}, )");
    CHECK(forth.transform.rotate.at(30) == 45);
    CHECK(forth.transform.rotate.keys.size() == 2);
    CHECK(forth.shown == std::vector<art::Span>{{10, std::numeric_limits<double>::infinity()}});
    const art::Node back = content(R"("tm": {"k": [{"t": 0, "s": [1]}, {"t": 60, "s": [0]}]}, )");
    CHECK(back.transform.rotate.at(20) == 60);
    CHECK(back.shown == std::vector<art::Span>{{-std::numeric_limits<double>::infinity(), 50}});
}

TEST_CASE("a remapping may hold, freeze, go back and be eased")
{
    const art::Node node = content(R"("tm": {"k": [{"t": 10, "s": [0.2]}, {"t": 20, "s": [1], "h": 1},
        {"t": 30, "s": [0.5], "o": {"x": 0.5, "y": 0}, "i": {"x": 0.5, "y": 1}}, {"t": 50, "s": [0]}]}, )");
    const auto& rotate = node.transform.rotate;
    CHECK(rotate.at(0) == 18);
    CHECK(rotate.at(15) == doctest::Approx(3 * (6 + 12)));
    CHECK(rotate.at(25) == 90);
    CHECK(rotate.at(30) == 45);
    CHECK(rotate.at(40) == doctest::Approx(22.5));
    const art::Ease ease{art::EaseKind::cubic, 0.5, 0, 0.5, 1};
    for (int frame = 31; frame < 50; ++frame)
        CHECK(rotate.at(frame) == doctest::Approx(45 * (1 - share_of_way(ease, (frame - 30) / 20.0))));
    CHECK(std::abs(rotate.at(55)) < 1e-9);
    REQUIRE(node.shown.size() == 1);
    CHECK(node.shown[0].from == 0);
    CHECK(node.shown[0].to > 41);
    CHECK(node.shown[0].to < 42);
}

TEST_CASE("eases within a remapping are divided exactly")
{
    const std::string eased =
        R"({"ty": 1, "nm": "box", "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60,
        "ks": {"r": {"k": [{"t": 0, "s": 0, "o": {"x": 0.7, "y": 0}, "i": {"x": 0.2, "y": 1}}, {"t": 30, "s": 90}]}}})";
    const art::Node node =
        content(R"("tm": {"k": [{"t": 0, "s": [0]}, {"t": 20, "s": [0.5]}, {"t": 40, "s": [0.25]},
        {"t": 60, "s": [0.25]}]}, )",
                eased);
    const art::Ease ease{art::EaseKind::cubic, 0.7, 0, 0.2, 1};
    for (double frame = 0; frame < 60; frame += 0.5) {
        const double inner = frame < 20 ? frame * 0.75 : frame < 40 ? 15 - (frame - 20) * 0.375 : 7.5;
        CHECK(node.transform.rotate.at(frame) ==
              doctest::Approx(90 * share_of_way(ease, inner / 30)).epsilon(1e-4));
    }
}

TEST_CASE("a composition that is missing, or uses itself, is refused")
{
    CHECK(failure_of(animation_text(precomposition(""))) ==
          "a.json: layers[0]: its composition \"c\" is not among the assets: export the file again");
    CHECK(failure_of(with_assets(precomposition(""), precomposition(""))) ==
          "a.json: assets[0].layers[0]: the composition \"c\" uses itself: take this layer out");
    CHECK(failure_of(animation_text(precomposition(""), R"("assets": [{"id": "c", "p": "a.png"}], ")")) !=
          "");
}

TEST_CASE("compositions that use the next one many times are too much, if they are written out")
{
    std::string assets;
    for (int i = 0; i < 20; ++i) {
        std::string layers;
        for (int k = 0; k < 10; ++k)
            layers += std::string{k == 0 ? "" : ","} + R"({"ty": 0, "ip": 0, "op": 60, "refId": "c)" +
                      std::to_string(i + 1) + "\"}";
        assets += R"({"id": "c)" + std::to_string(i) + R"(", "layers": [)" + layers + "]},";
    }
    assets += R"({"id": "c20", "layers": [])";
    const std::string text =
        animation_text(R"({"ty": 0, "ip": 0, "op": 60, "refId": "c0"})", R"("assets": [)" + assets + "}], ");
    CHECK(failure_of(text, Repeated::written_out).find("more than 65535 layers") != std::string::npos);
    CHECK(read_whole(text).symbols.size() == 20);
}

TEST_CASE("what reaches beyond a precomposition is cut or reported, if the canvas does not end there as well")
{
    const std::string line = R"({"ty": 4, "ip": 0, "op": 60, "shapes": [{"ty": "rc", "s": {"k": [200, 10]},
        "p": {"k": [0, 20]}}, {"ty": "st", "c": {"k": [1, 0, 0]}, "w": {"k": 2}}]})";
    const std::string far =
        R"({"ty": 1, "nm": "box", "sw": 200, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60})";
    CHECK(read_whole(with_assets(precomposition(""), far)).nodes.size() == 1);
    art::Losses losses;
    const std::string aside = precomposition(R"("ks": {"p": {"k": [-20, 0]}}, )");
    CHECK(read_whole(with_assets(precomposition(R"("ks": {"p": {"k": [10, 0]}}, )"), far)).nodes.size() == 1);
    CHECK(read_whole(with_assets(aside, far)).nodes.size() == 1);
    CHECK(read_whole(with_assets(precomposition(""), line)).nodes.size() == 1);
    read_with(with_assets(aside, line), losses);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "edge of a precomposition");
    CHECK(losses.list()[0].layer == "comp");
}

TEST_CASE("a composition that is held at the end of its layer shows the frame before")
{
    const std::string inner =
        R"({"ty": 1, "nm": "box", "sw": 20, "sh": 10, "sc": "#ff8000", "ip": 0, "op": 60})";
    const art::Node node = content(R"("tm": {"k": [{"t": 0, "s": [0]}, {"t": 30, "s": [2]}]}, )", inner);
    CHECK(node.shown.back().to >= 60);
}

TEST_CASE("a composition with a rate of its own is reported")
{
    art::Losses losses;
    read_with(animation_text(precomposition(""), R"("assets": [{"id": "c", "fr": 12, "layers": []}], )"),
              losses);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "frame rate of a composition");
}
