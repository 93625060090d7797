#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string group(const std::string& parameters, const std::string& layers)
{
    return "<layer type=\"group\" version=\"0.3\" desc=\"all\">" + parameters +
           "<param name=\"canvas\"><canvas>" + layers + "</canvas></param></layer>";
}

const std::string ball = layer("circle", "");

const art::Group& content(const art::Node& node) { return std::get<art::Group>(node.content); }

}

TEST_CASE("a group turns about its origin, and moves that to its offset")
{
    const std::string placement =
        "<composite type=\"transformation\"><offset>" + vector("1", "0.5") +
        "</offset><angle><angle value=\"30\"/></angle><skew_angle><angle value=\"0\"/></skew_angle><scale>" +
        vector("2", "0.5") + "</scale></composite>";
    const ReadFile file = read_layers(
        group(parameter("transformation", placement) + parameter("origin", vector("0.2", "0")), ball));
    const art::Transform& transform = file.node().transform;
    CHECK(transform.anchor_x.value() == doctest::Approx(110));
    CHECK(transform.x.value() == doctest::Approx(150));
    CHECK(transform.y.value() == doctest::Approx(25));
    CHECK(transform.rotate.value() == doctest::Approx(-30));
    CHECK(transform.scale_x.value() == 2);
    CHECK(transform.scale_y.value() == 0.5);
    CHECK(file.losses.empty());
}

TEST_CASE("layers that move act on all below them, and on nothing above")
{
    const ReadFile file =
        read_layers(ball + layer("translate", parameter("origin", vector("1", "0"))) + layer("star", ""));
    REQUIRE(file.document.nodes.size() == 2);
    CHECK(file.document.nodes[0].transform.x.value() == doctest::Approx(50));
    CHECK(content(file.document.nodes[0]).nodes.size() == 1);
    CHECK(std::holds_alternative<art::Shape>(file.document.nodes[1].content));
}

TEST_CASE("deeper layers lie lower")
{
    const auto named = [](const std::string& name, const std::string& depth) {
        return "<layer type=\"circle\" desc=\"" + name + "\">" + parameter("z_depth", real(depth)) +
               "</layer>";
    };
    const ReadFile file = read_layers(named("near", "-2") + named("middle", "0") + named("far", "2.5"));
    REQUIRE(file.document.nodes.size() == 3);
    CHECK(file.document.nodes[0].name == "far");
    CHECK(file.document.nodes[1].name == "middle");
    CHECK(file.document.nodes[2].name == "near");
}

TEST_CASE("what is painted behind comes first")
{
    const ReadFile file = read_layers(ball + "<layer type=\"star\" desc=\"behind\">" +
                                      parameter("blend_method", "<integer value=\"12\"/>") + "</layer>");
    CHECK(file.document.nodes.at(0).name == "behind");
    CHECK(file.losses.empty());
}

TEST_CASE("a group runs at its own time")
{
    const std::string fading =
        layer("circle", parameter("amount", "<animated type=\"real\"><waypoint time=\"0s\">" + real("0") +
                                                "</waypoint><waypoint time=\"1s\">" + real("1") +
                                                "</waypoint></animated>"));
    const ReadFile file = read_layers(group(parameter("time_offset", "<time value=\"-5f\"/>"), fading));
    const art::Channel& opacity = content(file.node()).nodes.at(0).opacity;
    CHECK(opacity.at(5) == doctest::Approx(0));
    CHECK(opacity.at(15) == doctest::Approx(1));
}

TEST_CASE("a switch shows one layer at a time")
{
    const std::string names =
        "<animated type=\"string\"><waypoint time=\"0s\"><string>one</string></waypoint>"
        "<waypoint time=\"1s\"><string>two</string></waypoint></animated>";
    const ReadFile file = read_layers("<layer type=\"switch\">" + parameter("layer_name", names) +
                                      "<param name=\"canvas\"><canvas><layer type=\"circle\" desc=\"one\"/>"
                                      "<layer type=\"circle\" desc=\"two\"/></canvas></param></layer>");
    const auto& nodes = content(file.node()).nodes;
    REQUIRE(nodes.size() == 2);
    REQUIRE(nodes[0].shown.size() == 1);
    CHECK(nodes[0].shown[0].to == 10);
    REQUIRE(nodes[1].shown.size() == 1);
    CHECK(nodes[1].shown[0].from == 10);
}

TEST_CASE("exported canvases are read where they are used")
{
    const ReadFile file =
        read_text(canvas("<defs><canvas id=\"wheel\"><layer type=\"circle\"/></canvas></defs>"
                         "<layer type=\"group\"><param name=\"canvas\" use=\"wheel\"/></layer>"
                         "<layer type=\"group\"><param name=\"canvas\" use=\":wheel\"/></layer>"));
    CHECK(content(file.document.nodes.at(0)).nodes.size() == 1);
    CHECK(content(file.document.nodes.at(1)).nodes.size() == 1);
}

TEST_CASE("named key frames are markers")
{
    const ReadFile file = read_text(canvas("<keyframe time=\"1s\">jump</keyframe><keyframe time=\"0s\"/>"));
    REQUIRE(file.document.markers.size() == 1);
    CHECK(file.document.markers[0].name == "jump");
    CHECK(file.document.markers[0].time == 10);
}
