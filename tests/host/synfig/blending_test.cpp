#include "tests/host/synfig/read_file.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string colour(const std::string& red, const std::string& green, const std::string& blue,
                   const std::string& alpha = "1")
{
    return "<color><r>" + red + "</r><g>" + green + "</g><b>" + blue + "</b><a>" + alpha + "</a></color>";
}

std::string stop(const std::string& position, const std::string& red, const std::string& alpha)
{
    return "<color pos=\"" + position + "\"><r>" + red + "</r><g>0</g><b>0</b><a>" + alpha + "</a></color>";
}

std::string gradient(const std::string& stops)
{
    return parameter("gradient", "<gradient>" + stops + "</gradient>");
}

std::string method(const std::string& number)
{
    return parameter("blend_method", "<integer value=\"" + number + "\"/>");
}

std::string solid(const std::string& blend, const std::string& inside)
{
    return layer("SolidColor", method(blend) + parameter("color", inside));
}

std::string group(const std::string& parameters, const std::string& layers)
{
    return "<layer type=\"group\" version=\"0.3\" desc=\"all\">" + parameters +
           "<param name=\"canvas\"><canvas>" + layers + "</canvas></param></layer>";
}

const std::string red_ball = layer("circle", parameter("color", colour("1", "0", "0")));

art::Rgb colour_of(const art::Node& node) { return std::get<art::Shape>(node.content).fill->colour.value(); }

}

TEST_CASE("a colour onto everything tints what lies below, and nothing above")
{
    const ReadFile file = read_layers(red_ball + solid("13", colour("0", "1", "0", "0.25")) + red_ball);
    REQUIRE(file.document.nodes.size() == 2);
    CHECK(colour_of(file.document.nodes[0]).red == doctest::Approx(0.75));
    CHECK(colour_of(file.document.nodes[0]).green == doctest::Approx(0.25));
    CHECK(colour_of(file.document.nodes[1]).green == 0);
    CHECK(file.losses.empty());
}

TEST_CASE("a colour multiplies, lightens and adds")
{
    const auto tinted = [](const std::string& number) {
        return colour_of(read_layers(red_ball + solid(number, colour("0.5", "0.5", "0"))).node());
    };
    CHECK(tinted("6").red == doctest::Approx(0.5));
    CHECK(tinted("6").green == 0);
    CHECK(tinted("16").red == doctest::Approx(1));
    CHECK(tinted("16").green == doctest::Approx(0.5));
    CHECK(tinted("4").red == doctest::Approx(1));
    CHECK(tinted("5").red == doctest::Approx(0.5));
}

TEST_CASE("tints go into groups, and blend in the colours of the file")
{
    const std::string content = group("", red_ball) + solid("13", colour("0", "0", "1", "0.5"));
    const ReadFile file = read_text(canvas(content, "version=\"1.0\""));
    const auto& nodes = std::get<art::Group>(file.node().content).nodes;
    CHECK(colour_of(nodes.at(0)).red == doctest::Approx(std::pow(0.5, 1 / 2.2)));
}

TEST_CASE("a group of nothing but a gradient tints by its mean colour, and tells")
{
    const std::string cover =
        layer("linear_gradient", gradient(stop("0", "0", "1") + stop("0.5", "1", "1") + stop("1", "1", "1")));
    const ReadFile file = read_layers(red_ball + group(method("13"), cover));
    REQUIRE(file.document.nodes.size() == 1);
    CHECK(colour_of(file.node()).red == doctest::Approx(0.75));
    REQUIRE(file.losses.list().size() == 1);
    CHECK(file.losses.list()[0].feature == "gradient");
    CHECK(read_layers(red_ball + group(method("13"), group("", cover))).document.nodes.size() == 1);
    const std::string faint = method("13") + parameter("amount", real("0.4"));
    CHECK(colour_of(read_layers(red_ball + group(faint, cover)).node()).red == doctest::Approx(0.9));
    const std::string hole = layer("circle", method("19"));
    const ReadFile left_out = read_layers(red_ball + group(method("13"), cover + hole));
    CHECK(colour_of(left_out.node()).red == 1);
    CHECK(left_out.losses.list().size() == 1);
}

TEST_CASE("what is transparent in a gradient has no say in the mean colour")
{
    const ReadFile file =
        read_layers(layer("linear_gradient", gradient(stop("0", "1", "1") + stop("0.8", "0", "0"))));
    CHECK(colour_of(file.node()).red == doctest::Approx(1));
    CHECK(file.shape().fill->opacity.value() == doctest::Approx(0.4));
}

TEST_CASE("a radial gradient that fades out is a circle up to half of its opacity")
{
    const ReadFile file =
        read_layers(layer("radial_gradient", gradient(stop("0", "1", "1") + stop("1", "1", "0")) +
                                                 parameter("radius", real("1"))));
    const auto& outline = file.shape().drawing.value().outlines.at(0);
    CHECK(outline.from.x == doctest::Approx(100 + 25));
    CHECK(file.shape().fill->opacity.value() == doctest::Approx(2.0 / 3).epsilon(0.01));
    REQUIRE(file.losses.list().size() == 1);
    CHECK(file.losses.list()[0].instead == "a circle in its mean colour");
}

TEST_CASE("a colour straight over everything is all that is left")
{
    const ReadFile file = read_layers(red_ball + solid("1", colour("0", "1", "0")) + red_ball);
    REQUIRE(file.document.nodes.size() == 2);
    CHECK(colour_of(file.document.nodes[0]).green == 1);
    CHECK(file.losses.empty());
}

TEST_CASE("a shape straight over others is all that is left; straight onto them, that is told")
{
    CHECK(read_layers(red_ball + layer("circle", method("1"))).document.nodes.size() == 1);
    CHECK(read_layers(red_ball + layer("circle", method("1"))).losses.empty());
    const ReadFile onto = read_layers(red_ball + layer("circle", method("21")));
    CHECK(onto.document.nodes.size() == 1);
    CHECK(onto.losses.list().size() == 1);
    const std::string half = layer("circle", method("1") + parameter("amount", real("0.5")));
    CHECK(read_layers(red_ball + half).document.nodes.size() == 2);
}

TEST_CASE("an inverted shape onto others does not cover all of the canvas")
{
    const std::string inverted = parameter("invert", "<bool value=\"true\"/>");
    const ReadFile file = read_layers(red_ball + layer("star", method("13") + inverted));
    CHECK(file.document.nodes.size() == 1);
    CHECK(file.losses.list().size() == 1);
    CHECK(read_layers(red_ball + layer("star", inverted)).document.nodes.size() == 2);
}

TEST_CASE("onto nothing, nothing is drawn; straight, a layer stands alone")
{
    const ReadFile file = read_layers(layer("circle", method("13")));
    CHECK(file.document.nodes.empty());
    CHECK(file.losses.empty());
    CHECK(read_layers(layer("circle", method("1"))).document.nodes.size() == 1);
}

TEST_CASE("what is painted behind is not moved with what lies below it")
{
    const ReadFile file = read_layers(red_ball + layer("translate", parameter("origin", vector("1", "0"))) +
                                      layer("star", method("12")));
    REQUIRE(file.document.nodes.size() == 2);
    CHECK(std::holds_alternative<art::Shape>(file.document.nodes[0].content));
    CHECK(std::holds_alternative<art::Group>(file.document.nodes[1].content));
}

TEST_CASE("of two layers that are painted behind, the upper one lies lowest")
{
    const auto behind = [](const std::string& name) {
        return "<layer type=\"star\" desc=\"" + name + "\">" + method("12") + "</layer>";
    };
    const ReadFile file = read_layers(red_ball + behind("first") + behind("second"));
    REQUIRE(file.document.nodes.size() == 3);
    CHECK(file.document.nodes[0].name == "second");
    CHECK(file.document.nodes[1].name == "first");
}
