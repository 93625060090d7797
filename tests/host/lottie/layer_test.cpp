#include "tests/host/lottie/lottie_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::lottie;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

std::string null_layer(const std::string& more)
{
    return R"({"ty": 3, "ip": 0, "op": 60, )" + more + R"("nm": "null"})";
}

art::Node first(const std::string& layers) { return read_whole(animation_text(layers)).nodes.at(0); }

}

TEST_CASE("a solid without a colour is black, and reported")
{
    art::Losses losses;
    const art::Document document = read_with(
        animation_text(R"({"ty": 1, "nm": "wall", "sw": 9, "sh": 9, "sc": "", "ip": 0, "op": 60})"), losses);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "solid of the colour \"\"");
    CHECK(shape_of(group_of(document.nodes.at(0)).nodes.at(0)).fill->colour.value() == art::Rgb{});
}

TEST_CASE("the canvas, the rate and the length are those of the file")
{
    const art::Document document =
        read_whole(R"({"w": 320, "h": 240, "fr": 25, "ip": 10, "op": 60, "layers": []})");
    CHECK(document.width == 320);
    CHECK(document.height == 240);
    CHECK(document.frame_rate == 25);
    CHECK(document.frames == 50);
    CHECK(document.nodes.empty());
    CHECK_FALSE(document.background);
    CHECK_FALSE(document.camera);
}

TEST_CASE("a scene begins where the file is played from")
{
    const art::Document document = read_whole(
        R"({"w": 9, "h": 9, "fr": 30, "ip": 10, "op": 60, "layers": [{"ty": 1, "sw": 2, "sh": 2, "sc": "#ffffff",
            "ip": 20, "op": 60, "ks": {"r": {"k": [{"t": 10, "s": 0}, {"t": 20, "s": 90}]}}}]})");
    const art::Node& node = document.nodes.at(0);
    CHECK(node.transform.rotate.keys[0].time == 0);
    CHECK(node.transform.rotate.keys[1].time == 10);
    CHECK(node.shown == std::vector<art::Span>{{10, endless}});
}

TEST_CASE("the first layer of the file is on top")
{
    const art::Document document = read_whole(animation_text(solid("", "upper") + "," + solid("", "lower")));
    REQUIRE(document.nodes.size() == 2);
    CHECK(document.nodes[0].name == "lower");
    CHECK(document.nodes[1].name == "upper");
}

TEST_CASE("a solid is a rectangle of its colour")
{
    const art::Node node = first(solid(R"("ks": {"p": {"k": [7, 8]}, "o": {"k": 50}}, )"));
    CHECK(node.name == "box");
    CHECK(node.opacity.value() == 0.5);
    CHECK(node.transform.x.value() == 7);
    CHECK(node.transform.y.value() == 8);
    const art::Shape& shape = shape_of(group_of(node).nodes.at(0));
    CHECK(shape.fill->colour.value() == art::Rgb{1, 128 / 255.0, 0});
    const scene::Outline& outline = shape.drawing.value().outlines.at(0);
    CHECK(outline.curves.size() == 3);
    CHECK(outline.curves[1].to.x == 20);
    CHECK(outline.curves[1].to.y == 10);
}

TEST_CASE("layers are seen from their in point to their out point, and not when they are hidden")
{
    CHECK(first(solid("")).shown == std::vector<art::Span>{{}});
    const art::Document document =
        read_whole(animation_text(solid(R"("hd": true, )") + "," + null_layer("")));
    CHECK(document.nodes.empty());
    const std::string late = R"({"ty": 1, "sw": 2, "sh": 2, "sc": "#ffffff", "ip": 12, "op": 20})";
    CHECK(first(late).shown == std::vector<art::Span>{{12, 20}});
    const std::string never = R"({"ty": 1, "sw": 2, "sh": 2, "sc": "#ffffff", "ip": 70, "op": 80})";
    CHECK(read_whole(animation_text(never)).nodes.empty());
}

TEST_CASE("a start time moves no keys, and a stretch none but those of precompositions")
{
    const art::Node node =
        first(solid(R"("st": 10, "sr": 2, "ks": {"r": {"k": [{"t": 10, "s": 0}, {"t": 20, "s": 90}]}}, )"));
    CHECK(node.transform.rotate.keys[0].time == 10);
    CHECK(node.transform.rotate.keys[1].time == 20);
}

TEST_CASE("parents are groups around their children, which do not fade with them")
{
    const art::Document document = read_whole(
        animation_text(solid(R"("ind": 1, "parent": 2, )", "hand") + "," +
                       null_layer(R"("ind": 2, "parent": 3, "hd": true, "ks": {"r": {"k": 30}}, )") + "," +
                       solid(R"("ind": 3, "ks": {"o": {"k": 20}, "p": {"k": [50, 40]}}, )", "body") + "," +
                       solid(R"("ind": 4, "parent": 3, )", "foot")));
    REQUIRE(document.nodes.size() == 3);
    const art::Node& foot = document.nodes[0];
    const art::Node& body = document.nodes[1];
    const art::Node& hand = document.nodes[2];
    CHECK(foot.parent_tag != 0);
    CHECK(foot.parent_tag == body.parent_tag);
    CHECK(hand.parent_tag == body.parent_tag);
    for (const art::Node* node : {&foot, &body, &hand}) {
        CHECK(node->name == "body");
        CHECK(node->transform.x.value() == 50);
        CHECK(node->opacity.value() == 1);
    }
    CHECK(group_of(body).nodes.at(0).opacity.value() == 0.2);
    CHECK(group_of(foot).nodes.at(0).name == "foot");
    const art::Node& null = group_of(hand).nodes.at(0);
    CHECK(null.name == "null");
    CHECK(null.transform.rotate.value() == 30);
    CHECK(null.parent_tag != body.parent_tag);
    CHECK(group_of(null).nodes.at(0).name == "hand");
}

TEST_CASE("parents that go round in a circle are refused")
{
    CHECK(failure_of(animation_text(solid(R"("ind": 1, "parent": 2, )") + "," +
                                    solid(R"("ind": 2, "parent": 1, )"))) ==
          "a.json: layers[1]: its parents go round in a circle: take one \"parent\" out");
    CHECK(failure_of(animation_text(solid(R"("ind": 1, "parent": 1, )"))) != "");
}

TEST_CASE("what covers the canvas at the bottom and never changes is the background")
{
    const std::string wall = R"({"ty": 1, "sw": 200, "sh": 200, "sc": "#000033", "ip": 0, "op": 60})";
    const art::Document document = read_whole(animation_text(solid("") + "," + wall));
    CHECK(document.background == art::Rgb{0, 0, 0.2});
    CHECK(document.nodes.size() == 1);
    for (const char* const change : {R"("ks": {"o": {"k": 50}}, )", R"("ks": {"p": {"k": [1, 0]}}, )",
                                     R"("ks": {"r": {"k": [{"t": 0, "s": 0}, {"t": 60, "s": 9}]}}, )"}) {
        const std::string changing = std::string{"{"} + change +
                                     R"("ty": 1, "sw": 200, "sh": 200, "sc": "#000033", "ip": 0, "op": 60})";
        CHECK_FALSE(read_whole(animation_text(changing)).background);
    }
    const std::string short_lived = R"({"ty": 1, "sw": 200, "sh": 200, "sc": "#000033", "ip": 0, "op": 59})";
    CHECK_FALSE(read_whole(animation_text(short_lived)).background);
    CHECK_FALSE(read_whole(animation_text(wall + "," + solid(""))).background);
}

TEST_CASE("markers are carried over, in frames of the scene")
{
    const art::Document document = read_whole(R"({"w": 9, "h": 9, "fr": 30, "ip": 5, "op": 60, "layers": [],
            "markers": [{"cm": "jump", "tm": 15, "dr": 4}, {"cm": "land", "tm": 30}]})");
    REQUIRE(document.markers.size() == 2);
    CHECK(document.markers[0].name == "jump");
    CHECK(document.markers[0].time == 10);
    CHECK(document.markers[0].duration == 4);
    CHECK(document.markers[1].duration == 0);
}
