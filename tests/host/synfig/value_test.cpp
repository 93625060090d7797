#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

double radius(const ReadFile& file)
{
    const auto& outline = file.shape().drawing.value().outlines.at(0);
    return (outline.from.x - 100) / 50;
}

const std::string black_to_red =
    "<gradient><gradient><color pos=\"0\"><r>0</r><g>0</g><b>0</b><a>1</a></color>"
    "<color pos=\"1\"><r>1</r><g>0</g><b>0</b><a>1</a></color></gradient></gradient>";

}

TEST_CASE("a colour is taken out of a gradient")
{
    const std::string value = "<gradientcolor type=\"color\">" + black_to_red + "<index>" + real("0.25") +
                              "</index><loop><bool value=\"false\"/></loop></gradientcolor>";
    const ReadFile file = read_layers(layer("circle", parameter("color", value)));
    CHECK(file.shape().fill->colour.value().red == doctest::Approx(0.25));
    CHECK(file.losses.empty());
}

TEST_CASE("a derivative is how fast a value changes, per second")
{
    const std::string value = "<derivative type=\"real\"><link><linear type=\"real\"><slope>" + real("0.5") +
                              "</slope><offset>" + real("3") + "</offset></linear></link><interval>" +
                              real("0.01") + "</interval></derivative>";
    CHECK(radius(read_layers(layer("circle", parameter("radius", value)))) == doctest::Approx(0.5));
}

TEST_CASE("a random value stays at its middle, and the layer is told")
{
    const std::string value = "<random type=\"real\"><link>" + real("0.5") + "</link><radius>" + real("2") +
                              "</radius><seed><integer value=\"1097865060\"/></seed></random>";
    const ReadFile file = read_layers(layer("circle", parameter("radius", value)));
    CHECK(radius(file) == doctest::Approx(0.5));
    REQUIRE(file.losses.list().size() == 1);
    CHECK(file.losses.list()[0].feature == "value <random>");
    CHECK(file.losses.list()[0].layer == "thing");
}

TEST_CASE("values and canvases of other files are told, and not mixed up with own ones")
{
    const ReadFile file =
        read_text(canvas("<defs><color id=\"gold\"><r>1</r><g>1</g><b>0</b><a>1</a></color></defs>"
                         "<layer type=\"circle\"><param name=\"color\" use=\"other.sif#:gold\"/></layer>"));
    CHECK(file.shape().fill->colour.value().red == 0);
    REQUIRE(file.losses.list().size() == 1);
    CHECK(file.losses.list()[0].feature == "value \"other.sif#:gold\" of another file");
}

TEST_CASE("files of old versions number the parts of composites")
{
    const std::string polar = "<radial_composite type=\"vector\"><c0>" + real("0.5") +
                              "</c0><c1><angle value=\"90\"/></c1></radial_composite>";
    const std::string origin =
        "<composite type=\"vector\"><c1>" + real("1") + "</c1><c2>" + real("-0.5") + "</c2></composite>";
    const auto middle = [](const std::string& value) {
        const ReadFile file = read_layers(
            layer("rectangle", parameter("point1", value) + parameter("point2", vector("0", "0"))));
        return file.shape().drawing.value().outlines.at(0);
    };
    CHECK(middle(origin).curves.at(0).to.x == doctest::Approx(150));
    CHECK(middle(origin).curves.at(1).to.y == doctest::Approx(75));
    CHECK(middle(polar).from.y == doctest::Approx(25));
}
