#include "host/art/prepare/prepare.hpp"
#include "host/geometry/shape.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using art::Channel;
using art::Document;
using art::Node;
using art::Shape;

TEST_CASE("everything that is a length is scaled, and nothing else")
{
    Shape shape;
    shape.drawing = art::Drawing{{scene::ellipse({10, 20}, 5, 6)}};
    shape.stroke.emplace().width = Channel{{{0, 2, {}}, {9, 3, {}}}};
    shape.stroke->opacity = 0.5;
    Node leaf;
    leaf.content = shape;
    leaf.transform.path = {{{scene::Outline{{1, 2}, {scene::line_to({3, 4})}, false}}}, 0.25};
    leaf.opacity = 0.75;
    Node node;
    node.content = art::Group{{leaf}};
    node.transform.x = Channel{{{0, 1, {}}, {9, 2, {}}}};
    node.transform.y = 3;
    node.transform.z = 4;
    node.transform.anchor_x = 5;
    node.transform.anchor_y = 6;
    node.transform.rotate = 7;
    node.transform.scale_x = 8;
    node.transform.skew = 9;
    Document document;
    document.width = 40;
    document.height = 30;
    document.camera = 100;
    document.nodes.push_back(node);
    document.rigs.push_back({"rig", {{"bone", {}, {1, 1}, {2, 3}, 45, 1, 2, Channel{4}, false}}});

    art::scale(document, 2);
    CHECK(document.width == 80);
    CHECK(document.height == 60);
    CHECK(*document.camera == 200);
    const auto& outer = document.nodes[0].transform;
    CHECK(outer.x.keys[1].value == 4);
    CHECK(outer.x.keys[1].time == 9);
    CHECK(outer.y.value() == 6);
    CHECK(outer.z.value() == 8);
    CHECK(outer.anchor_x.value() == 10);
    CHECK(outer.anchor_y.value() == 12);
    CHECK(outer.rotate.value() == 7);
    CHECK(outer.scale_x.value() == 8);
    CHECK(outer.skew.value() == 9);
    const Node& inner = std::get<art::Group>(document.nodes[0].content).nodes[0];
    CHECK(inner.opacity.value() == 0.75);
    CHECK(inner.transform.path->path.outlines[0].curves[0].to.x == 6);
    CHECK(inner.transform.path->share.value() == 0.25);
    const auto& drawn = std::get<Shape>(inner.content);
    CHECK(drawn.drawing.value() == art::Drawing{{scene::ellipse({20, 40}, 10, 12)}});
    CHECK(drawn.stroke->width.keys[1].value == 6);
    CHECK(drawn.stroke->opacity.value() == 0.5);
    const art::Bone& bone = document.rigs[0].bones[0];
    CHECK(bone.from.x == 2);
    CHECK(bone.to.y == 6);
    CHECK(bone.rotation.value() == 45);
    CHECK(bone.x.value() == 2);
    CHECK(bone.y.value() == 4);
    CHECK(bone.length->value() == 8);
}

}
