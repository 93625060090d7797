#include "host/geometry/shape.hpp"
#include "tests/host/svg/drawing_text.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::vector<double> box_of(std::string_view content,
                           std::string_view attributes = R"(width="100" height="100")")
{
    return box(shape(read_drawing(content, attributes), "it").drawing.value());
}

std::size_t nodes_of(std::string_view content) { return read_drawing(content).nodes.size(); }

using Box = std::vector<double>;

}

TEST_CASE("a drawing is a scene of one frame, as large as it says")
{
    const auto document = read_drawing(R"(<rect width="5" height="5"/>)", R"(width="1in" height="48")");
    CHECK(document.width == 96);
    CHECK(document.height == 48);
    CHECK(document.frames == 1);
    CHECK(document.nodes.size() == 1);
    CHECK(document.nodes.front().name == "rect");
}

TEST_CASE("a drawing without a size is as large as its view box")
{
    CHECK(read_drawing("", R"(viewBox="0 0 30 40")").width == 30);
    CHECK(read_drawing("", R"(viewBox="0 0 30 40" height="80")").width == 60);
    CHECK(read_drawing("", R"(viewBox="0 0 30 40" width="100%" height="100%")").height == 40);
    CHECK(read_drawing("", "").width == 300);
    CHECK(read_drawing("", "").height == 150);
}

TEST_CASE("shapes have the outlines that scenes have for them")
{
    const auto rect =
        shape(read_drawing(R"(<rect id="it" x="1" y="2" width="30" height="40" rx="5"/>)"), "it");
    CHECK(rect.drawing.value() == art::Drawing{{scene::rectangle({1, 2}, 30, 40, 5)}});
    const auto circle = shape(read_drawing(R"(<circle id="it" cx="10" cy="20" r="5"/>)"), "it");
    CHECK(circle.drawing.value() == art::Drawing{{scene::ellipse({10, 20}, 5, 5)}});
    CHECK(box_of(R"(<ellipse id="it" cx="20" cy="20" rx="5" ry="8"/>)") == Box{15, 12, 25, 28});
    CHECK(box_of(R"(<ellipse id="it" cx="20" cy="20" rx="5"/>)") == Box{15, 15, 25, 25});
    CHECK(box_of(R"(<polygon id="it" points="1,2 3,4 5-6"/>)") == Box{1, -6, 5, 4});
    CHECK(box_of(R"(<line id="it" x1="1" y1="2" x2="3" y2="4" stroke="red"/>)") == Box{1, 2, 3, 4});
    CHECK(box_of(R"(<path id="it" d="M5000 0h10v10z"/>)") == Box{5000, 0, 5010, 10});
    CHECK(box_of(R"(<rect id="it" x="10%" y="10%" width="50%" height="20%"/>)", R"(viewBox="0 0 200 100")") ==
          Box{20, 10, 120, 30});
}

TEST_CASE("corners of a rectangle are cut as in SVG")
{
    CHECK(shape(read_drawing(R"(<rect id="it" width="30" height="40" rx="500"/>)"), "it")
              .drawing.value()
              .outlines.front()
              .from.x == 15);
    const auto elliptic =
        shape(read_drawing(R"(<rect id="it" width="30" height="40" rx="5" ry="10"/>)"), "it");
    CHECK(elliptic.drawing.value().outlines.front().curves.size() == 8);
    CHECK(elliptic.drawing.value().outlines.front().from.x == 5);
}

TEST_CASE("what draws nothing is no node")
{
    CHECK(nodes_of(R"(<rect width="0" height="9"/><circle r="0"/><circle/><polygon points="1 2"/><path/>)") ==
          0);
    CHECK(nodes_of(R"(<rect width="9" height="9" fill="none"/>)") == 0);
    CHECK(nodes_of(R"(<rect width="9" height="9" opacity="0"/>)") == 0);
    CHECK(nodes_of(R"(<rect width="9" height="9" fill-opacity="0"/>)") == 0);
    CHECK(nodes_of(R"(<line x2="9" fill="red"/>)") == 0);
    CHECK(nodes_of(
              R"(<rect width="9" height="9" display="none"/><g visibility="hidden"><circle r="4"/></g>)") ==
          0);
    CHECK(nodes_of(R"(<defs><rect width="9" height="9"/></defs><symbol><circle r="5"/></symbol>)") == 0);
    CHECK(nodes_of(R"(<rect width="9" height="9" stroke="red" fill="none" stroke-width="0"/>)") == 0);
}

TEST_CASE("a use is named by itself, else by what it shows")
{
    const auto document = read_drawing(R"(
        <defs><circle id="dot" r="5"/></defs>
        <use href="#dot" x="20" y="30"/><use id="other" href="#dot"/>)");
    CHECK(box(shape(document, "dot").drawing.value()) == Box{15, 25, 25, 35});
    CHECK(box(shape(document, "other").drawing.value()) == Box{-5, -5, 5, 5});
}

TEST_CASE("a symbol is as large as its use says")
{
    const auto document = read_drawing(R"(
        <symbol id="sign" viewBox="0 0 10 10"><rect id="it" width="10" height="10"/></symbol>
        <use id="used" href="#sign" x="5" y="6" width="40" height="40"/>)");
    CHECK(box(shape(document, "it").drawing.value()) == Box{5, 6, 45, 46});
}

TEST_CASE("dashes are those of the line")
{
    const auto document = read_drawing(R"svg(
        <rect id="it" width="30" height="10" fill="red" stroke="blue" stroke-dasharray="5 6"/>
        <path id="only" d="M0 0H20" stroke="blue" stroke-dasharray="5" stroke-dashoffset="2"/>
        <path id="grown" d="M0 0H20" stroke="blue" stroke-dasharray="5 3" transform="scale(2)"/>)svg");
    const auto lengths = [&](const char* name) {
        std::vector<double> values;
        for (const art::Channel& length : shape(document, name).stroke->dashes.lengths)
            values.push_back(length.value());
        return values;
    };
    CHECK(shape(document, "it").drawing.value().outlines.size() == 1);
    CHECK(shape(document, "it").fill);
    CHECK(lengths("it") == std::vector<double>{5, 6});
    CHECK(lengths("only") == std::vector<double>{5, 5});
    CHECK(shape(document, "only").stroke->dashes.offset.value() == 2);
    CHECK(lengths("grown") == std::vector<double>{10, 6});
}

TEST_CASE("dashes that scenes do not have are strokes of their own, above the fill")
{
    const auto document = read_drawing(R"svg(
        <rect id="it" width="30" height="10" fill="red" stroke="blue" stroke-dasharray="5 5 5 5 5 5 5 5"/>)svg");
    CHECK(shape(document, "it").drawing.value().outlines.size() == 1);
    CHECK_FALSE(shape(document, "it").stroke);
    CHECK(shape(document, "it line").drawing.value().outlines.size() == 8);
    CHECK_FALSE(shape(document, "it line").fill);
}

TEST_CASE("a dash as long as its line is a bit longer, so that an offset draws it from nothing to all")
{
    const auto document = read_drawing(R"(
        <path id="it" d="M0 0H100" stroke="blue" stroke-dasharray="100" stroke-dashoffset="100"/>)");
    const art::Dashes& dashes = shape(document, "it").stroke->dashes;
    CHECK(dashes.lengths[0].value() == doctest::Approx(100.5));
    CHECK(dashes.offset.value() == doctest::Approx(100.5));
}

TEST_CASE("an author's length of a path counts for its dashes")
{
    const auto document =
        read_drawing(R"(<path id="it" d="M0 0H100" stroke="blue" stroke-dasharray="1 1" pathLength="10"/>)");
    CHECK(shape(document, "it").stroke->dashes.lengths[0].value() == 10);
}

TEST_CASE("a line below its fill is a figure below it")
{
    const auto document = read_drawing(
        R"(<g id="g"><circle id="it" r="9" fill="red" stroke="blue" paint-order="stroke"/></g>)");
    REQUIRE(document.nodes.size() == 2);
    CHECK(document.nodes[0].name == "it line");
    CHECK(document.nodes[1].name == "it");
}

TEST_CASE("a radius below nothing is as the other one")
{
    CHECK(box_of("<ellipse id='it' cx='50' cy='50' rx='-3' ry='20'/>") == Box{30, 30, 70, 70});
    CHECK(box_of("<ellipse id='it' cx='50' cy='50' rx='20' ry='-3'/>") == Box{30, 30, 70, 70});
    const auto rect = shape(read_drawing("<rect id='it' width='30' height='40' rx='-2' ry='5'/>"), "it");
    CHECK(rect.drawing.value() == art::Drawing{{scene::rectangle({0, 0}, 30, 40, 5)}});
}

TEST_CASE("elements are of SVG by their namespace, not by their prefix")
{
    const auto document = read_drawing(R"(
        <s:g xmlns="http://example.org/other" xmlns:s="http://www.w3.org/2000/svg" xmlns:t="http://example.org/other">
            <s:rect id="it" width="9" height="9"/><rect id="other" width="9" height="9"/><t:rect width="9" height="9"/>
        </s:g><rect id="behind" width="9" height="9"/><s:rect width="9" height="9"/>)");
    CHECK(document.nodes.size() == 2);
    CHECK(document.nodes.front().name == "it");
    CHECK(document.nodes.back().name == "behind");
    CHECK(failure_of("<svg width='9' height='9'><rect width='3' height='3'/></svg>").empty());
}

TEST_CASE("a background that is half transparent lies on a white page")
{
    const auto document = read_drawing("", R"(width="9" height="9" style="background-color:#0000ff80")");
    CHECK(hex(*document.background) == "#7f7fff");
}

TEST_CASE("em is of the element, rem of the outermost one")
{
    CHECK(box_of("<g font-size='20'><rect id='it' width='1em' height='1rem'/></g>",
                 "width='100' height='100' font-size='10'") == Box{0, 0, 20, 10});
}
