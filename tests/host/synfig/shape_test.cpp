#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string point(const std::string& x, const std::string& y, const std::string& tangent)
{
    return "<entry><composite type=\"bline_point\"><point>" + vector(x, y) + "</point><width>" + real("1") +
           "</width><origin>" + real("0.5") + "</origin><split><bool value=\"false\"/></split><t1>" +
           tangent + "</t1><t2>" + tangent + "</t2></composite></entry>";
}

std::string spline(const std::string& points)
{
    return "<bline type=\"bline_point\" loop=\"true\">" + points + "</bline>";
}

}

TEST_CASE("places of a file, y up, become pixels, y down")
{
    const ReadFile file = read_layers(
        layer("rectangle", parameter("point1", vector("-1", "0.5")) + parameter("point2", vector("1", "0"))));
    const auto& outline = file.shape().drawing.value().outlines.at(0);
    CHECK(outline.from.x == doctest::Approx(50));
    CHECK(outline.from.y == doctest::Approx(25));
    REQUIRE(outline.curves.size() == 3);
    CHECK(outline.curves[1].to.x == doctest::Approx(150));
    CHECK(outline.curves[1].to.y == doctest::Approx(50));
}

TEST_CASE("tangents are three times the arms of a curve")
{
    const ReadFile file =
        read_layers(layer("region", parameter("bline", spline(point("-1", "0", vector("0", "0.6")) +
                                                              point("1", "0", vector("0", "-0.6"))))));
    const auto& outline = file.shape().drawing.value().outlines.at(0);
    REQUIRE(outline.curves.size() == 2);
    CHECK(outline.closed);
    CHECK(outline.curves[0].c1.x == doctest::Approx(50));
    CHECK(outline.curves[0].c1.y == doctest::Approx(40));
    CHECK(outline.curves[0].c2.y == doctest::Approx(40));
}

TEST_CASE("points without tangents are joined by lines")
{
    const std::string none = vector("0", "0");
    const ReadFile file =
        read_layers(layer("region", parameter("bline", spline(point("-1", "0", none) + point("1", "0", none) +
                                                              point("0", "0.5", none)))));
    CHECK_FALSE(file.shape().drawing.value().outlines.at(0).curves.at(0).cubic);
}

TEST_CASE("colours are those of pictures: files before version 1.2 have linear ones")
{
    const std::string grey =
        layer("circle", parameter("color", "<color><r>0.5</r><g>0.5</g><b>0.5</b><a>0.25</a></color>"));
    CHECK(read_text(canvas(grey)).shape().fill->colour.value().red == doctest::Approx(0.5));
    CHECK(read_text(canvas(grey)).shape().fill->opacity.value() == doctest::Approx(0.25));
    const ReadFile old = read_text(canvas(grey, "version=\"1.0\""));
    CHECK(old.shape().fill->colour.value().red == doctest::Approx(0.7297).epsilon(0.001));
}

TEST_CASE("an inverted shape is a hole in all of the canvas")
{
    const ReadFile file = read_layers(layer("circle", parameter("invert", "<bool value=\"true\"/>")));
    CHECK(file.shape().drawing.value().outlines.size() == 2);
    CHECK(file.shape().fill->rule == FillRule::even_odd);
}

TEST_CASE("layers that are switched off are not there")
{
    CHECK(read_layers("<layer type=\"circle\" active=\"false\"/>").document.nodes.empty());
    CHECK(read_layers("<layer type=\"circle\" exclude_from_rendering=\"true\"/>").document.nodes.empty());
}

TEST_CASE("what cannot be carried over is reported with the layer that it is in")
{
    const ReadFile file =
        read_layers(layer("circle", parameter("feather", real("0.1"))) + layer("julia", ""));
    REQUIRE(file.losses.list().size() == 2);
    CHECK(file.losses.list()[0].feature == "layer \"julia\"");
    CHECK(file.losses.list()[1].feature == "soft edge");
    CHECK(file.losses.list()[1].layer == "thing");
}

TEST_CASE("an origin that changes moves the figure, each axis by its own keys")
{
    const std::string origin =
        "<animated type=\"vector\"><waypoint time=\"0s\" before=\"halt\" after=\"halt\">" + vector("0", "0") +
        "</waypoint><waypoint time=\"2s\" before=\"halt\" after=\"halt\">" + vector("1", "0.5") +
        "</waypoint></animated>";
    const ReadFile file = read_layers(layer("circle", parameter("origin", origin)));
    CHECK(file.shape().drawing.is_still());
    REQUIRE(file.node().transform.x.keys.size() == 2);
    CHECK(file.node().transform.x.keys[1].value == doctest::Approx(150));
    CHECK(file.node().transform.y.keys[1].value == doctest::Approx(25));
}

TEST_CASE("the background has no gamma")
{
    const ReadFile file = read_text(canvas("", "version=\"1.0\" bgcolor=\"0.5 0.25 0 1\""));
    REQUIRE(file.document.background);
    CHECK(file.document.background->red == 0.5);
    CHECK(file.document.background->green == 0.25);
    CHECK_FALSE(read_layers("").document.background);
}
