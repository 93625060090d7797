#include "tests/host/svg/drawing_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {
using Box = std::vector<double>;
}

TEST_CASE("transforms of what does not move go into the points")
{
    const auto document = read_drawing(R"(
        <g id="layer1" transform='translate(10 20)'><g id="g5" transform='scale(2)'>
        <rect id="it" width="5" height="6" transform='translate(1 1)'/></g></g>)");
    REQUIRE(document.nodes.size() == 1);
    CHECK(box(shape(document, "it").drawing.value()) == Box{12, 22, 22, 34});
    CHECK(document.nodes.front().transform == art::Transform{});
}

TEST_CASE("a view box is a transform as well")
{
    const auto document = read_drawing(R"(<rect id="it" x="10" y="10" width="10" height="10"/>)",
                                       R"(width="100" height="50" viewBox="10 10 20 20")");
    CHECK(box(shape(document, "it").drawing.value()) == Box{25, 0, 50, 25});
}

TEST_CASE("groups stay where an author has named them, or where they fade")
{
    const auto document = read_drawing(R"(
        <g id="g12"><rect id="loose" width="5" height="6"/><rect width="5" height="6"/></g>
        <g inkscape:label="arm" id="g13"><rect width="5" height="6"/><rect id="hand" width="5" height="6"/></g>
        <g opacity="0.5"><rect id="ghost" width="5" height="6"/></g>
        <g id="lid"><rect id="rect7" width="5" height="6"/></g>)");
    REQUIRE(document.nodes.size() == 5);
    CHECK(document.nodes[4].name == "lid");
    CHECK(document.nodes[0].name == "loose");
    CHECK(document.nodes[2].name == "arm");
    CHECK(std::get<art::Group>(document.nodes[2].content).nodes[1].name == "hand");
    CHECK(document.nodes[3].opacity.value() == 0.5);
}

TEST_CASE("a transform about an origin")
{
    const auto document = read_drawing(R"(
        <rect id="it" x="10" y="10" width="10" height="10" style="transform: scale(2); transform-origin: 10px 10px"/>
        <rect id="own" x="10" y="10" width="10" height="10"
         style="transform: scale(2); transform-origin: center; transform-box: fill-box"/>
        <rect id="page" x="10" y="10" width="10" height="10" style="transform: scale(2); transform-origin: right 50%"/>)");
    CHECK(box(shape(document, "it").drawing.value()) == Box{10, 10, 30, 30});
    CHECK(box(shape(document, "own").drawing.value()) == Box{5, 5, 25, 25});
    CHECK(box(shape(document, "page").drawing.value()) == Box{-80, -30, -60, -10});
}
