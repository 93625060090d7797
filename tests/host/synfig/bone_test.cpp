#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string bone(const std::string& guid, const std::string& parent, const std::string& x,
                 const std::string& angle, const std::string& stretch = real("1"))
{
    return "<bone type=\"bone_object\" guid=\"" + guid + "\"><name><string>bone " + guid +
           "</string></name><parent><bone_valuenode guid=\"" + parent + "\"/></parent><origin>" +
           vector(x, "0") + "</origin><angle>" + angle + "</angle><scalelx>" + stretch +
           "</scalelx><length>" + real("1") + "</length><width>" + real("0.4") + "</width><tipwidth>" +
           real("0.4") + "</tipwidth></bone>";
}

const std::string still = "<angle value=\"0\"/>";
const std::string turning = "<animated type=\"angle\"><waypoint time=\"0s\"><angle value=\"0\"/></waypoint>"
                            "<waypoint time=\"2s\"><angle value=\"90\"/></waypoint></animated>";

std::string pair(const std::string& rest, const std::string& pose)
{
    return "<entry><composite type=\"pair_bone_object_bone_object\"><first><bone guid=\"" + rest +
           "\"/></first><second><bone guid=\"" + pose + "\"/></second></composite></entry>";
}

ReadFile deformed(const std::string& bones)
{
    return read_text(canvas("<bones>" + bones + "</bones>" +
                            layer("rectangle", parameter("point1", vector("-1", "-0.1")) +
                                                   parameter("point2", vector("1", "0.1"))) +
                            layer("skeleton_deformation",
                                  parameter("blend_method", "<integer value=\"1\"/>") +
                                      parameter("bones", "<static_list type=\"pair\">" + pair("R1", "P1") +
                                                             pair("R2", "P2") + "</static_list>"))));
}

}

TEST_CASE("a skeleton deformation whose bones keep their lengths is a skeleton")
{
    const ReadFile file = deformed(bone("R1", "root", "-1", still) + bone("R2", "R1", "1", still) +
                                   bone("P1", "root", "-1", still) + bone("P2", "P1", "1", turning));
    REQUIRE(file.document.rigs.size() == 1);
    const auto& bones = file.document.rigs[0].bones;
    REQUIRE(bones.size() == 2);
    CHECK(bones[0].from.x == doctest::Approx(50));
    CHECK(bones[0].to.x == doctest::Approx(100));
    CHECK(bones[0].rotation.is_still());
    CHECK(bones[1].parent == std::size_t{0});
    REQUIRE(bones[1].rotation.keys.size() == 2);
    CHECK(bones[1].rotation.keys[1].value == doctest::Approx(-90));
    CHECK(bones[1].x.value() == doctest::Approx(0));
    REQUIRE(file.shape().skin);
    CHECK(file.shape().skin->points.size() > 4);
    for (const auto& shares : file.shape().skin->points) {
        CHECK(!shares.empty());
        CHECK(shares.size() <= 4);
    }
}

TEST_CASE("where bones are stretched the drawing follows them point by point")
{
    const std::string growing = "<animated type=\"real\"><waypoint time=\"0s\">" + real("1") +
                                "</waypoint><waypoint time=\"2s\">" + real("1.5") + "</waypoint></animated>";
    const ReadFile file = deformed(bone("R1", "root", "-1", still) + bone("R2", "R1", "1", still) +
                                   bone("P1", "root", "-1", still, growing) + bone("P2", "P1", "1", still));
    CHECK(file.document.rigs.empty());
    CHECK_FALSE(file.shape().skin);
    CHECK_FALSE(file.shape().drawing.is_still());
}

TEST_CASE("values that are linked to a bone go with it")
{
    const std::string link =
        "<bone_link type=\"vector\"><bone><bone_valuenode guid=\"P\"/></bone><base_value>" +
        vector("1", "0") + "</base_value></bone_link>";
    const ReadFile file = read_text(canvas("<bones>" + bone("P", "root", "0", turning) + "</bones>" +
                                           layer("circle", parameter("origin", link))));
    CHECK(file.node().transform.x.at(0) == doctest::Approx(150));
    CHECK(file.node().transform.y.at(20) == doctest::Approx(0));
    CHECK(file.node().transform.x.at(10) == doctest::Approx(100 + 50 * 0.70711).epsilon(0.001));
}

TEST_CASE("a region whose points are all linked to bones has them as its skin")
{
    const auto link = [](const std::string& place, const std::string& translate) {
        return "<bone_link type=\"vector\"><bone><bone_valuenode guid=\"P\"/></bone><base_value>" + place +
               "</base_value><translate><bool value=\"" + translate + "\"/></translate></bone_link>";
    };
    const auto point = [&](const std::string& x, const std::string& y) {
        const std::string tangent = link(vector("0.1", "0"), "false");
        return "<entry><composite type=\"bline_point\"><point>" + link(vector(x, y), "true") +
               "</point><t1>" + tangent + "</t1><t2>" + tangent + "</t2></composite></entry>";
    };
    const std::string spline = "<bline type=\"bline_point\" loop=\"true\">" + point("0", "0") +
                               point("1", "0") + point("0.5", "0.3") + "</bline>";
    const auto file = [&](const std::string& of_scope) {
        return read_text(canvas("<bones>" + bone("P", "root", "0", turning) + "</bones>" +
                                layer("region", parameter("bline", spline)) + of_scope));
    };
    const ReadFile plain = file("");
    REQUIRE(plain.document.rigs.size() == 1);
    CHECK(plain.document.rigs[0].bones.at(0).rotation.keys.size() == 2);
    REQUIRE(plain.shape().skin);
    CHECK(plain.shape().skin->points.size() == 3);
    CHECK(plain.shape().drawing.is_still());
    const ReadFile looped = file(layer("timeloop", parameter("duration", "<time value=\"1s\"/>")));
    CHECK(looped.document.rigs.empty());
    CHECK_FALSE(looped.shape().drawing.is_still());
}
