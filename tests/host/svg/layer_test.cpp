#include "host/svg/read_svg.hpp"
#include "tests/host/svg/drawing_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string layer(const std::string& name, const std::string& content, const std::string& attributes = "")
{
    return "<g inkscape:groupmode='layer' inkscape:label='" + name + "' " + attributes + ">" + content +
           "</g>";
}

const std::string small = "<circle inkscape:label='dot' id='c1' cx='20' cy='50' r='5'/>";
const std::string large = "<circle inkscape:label='dot' id='c2' cx='20' cy='50' r='9'/>";

}

TEST_CASE("layers that are named by frames are keys, all others stay")
{
    const auto document = read_drawing(layer("back", "<rect id='sky' width='100' height='9'/>") +
                                       layer("24: large", large) + layer("0", small, "style='display:none'") +
                                       layer("front", "<rect id='border' width='9' height='9'/>"));
    REQUIRE(document.nodes.size() == 3);
    CHECK(document.nodes[0].name == "sky");
    CHECK(document.nodes[1].name == "dot");
    CHECK(document.nodes[2].name == "border");
    CHECK(document.frames == 25);
    CHECK(find(document, "dot").transform.scale_x.keys.back().time == 24);
    CHECK(find(document, "dot").transform.scale_x.keys.back().value == doctest::Approx(1.8));
    CHECK(find(document, "sky").shown == std::vector{art::Span{}});
}

TEST_CASE("one such layer is none, nor are any if nobody wants them")
{
    CHECK(read_drawing(layer("0", small) + layer("more", large)).nodes.size() == 2);
    const auto still = read_drawing(layer("0", small) + layer("12", large), "width='9' height='9'",
                                    {.layers = svg::LayerKeys::never});
    CHECK(still.nodes.size() == 2);
    CHECK(still.frames == 1);
}

TEST_CASE("layers in seconds go by the frame rate")
{
    const auto document =
        read_drawing(layer("0s", small) + layer("0.5s", large), "width='9' height='9'", {.frame_rate = 20});
    CHECK(document.frames == 11);
}

TEST_CASE("layers that cannot be keys are refused")
{
    CHECK(failure_of(drawing(layer("0", small) + layer("f 0", large))) ==
          "test.svg: the layers \"0\" and \"f 0\" are named by the same frame: rename one of them");
    CHECK(failure_of(drawing(layer("0", small)), {.layers = svg::LayerKeys::always}).find("no two layers") !=
          std::string::npos);
    std::string many;
    for (int i = 0; i < 501; ++i)
        many += layer(std::to_string(i), small);
    CHECK(failure_of(drawing(many)).find("more than 500 layers") != std::string::npos);
    std::string shared;
    for (int i = 0; i < 60'000; ++i)
        shared += "<circle r='9'/>";
    CHECK(failure_of(drawing(shared + layer("0", small) + layer("1", small) + layer("2", small) +
                             layer("3", small) + layer("4", small)))
              .find("too many shapes outside of the 5 layers") != std::string::npos);
}

TEST_CASE("layers that are taken as keys by themselves are told")
{
    const std::string text =
        drawing("<g inkscape:label='0'><circle r='3'/></g><g inkscape:label='12'><circle r='4'/></g>");
    const auto notes = [&](svg::LayerKeys layers) {
        art::Losses losses;
        std::vector<std::string> messages;
        svg::read_svg({"a.svg", text}, {.layers = layers}, losses, messages);
        return messages;
    };
    CHECK(notes(svg::LayerKeys::automatic) ==
          std::vector<std::string>{"the layers \"0\", \"12\" are key drawings, by their names: "
                                   "--layers never draws them over each other"});
    CHECK(notes(svg::LayerKeys::always).empty());
    CHECK(notes(svg::LayerKeys::never).empty());
}
