#include "host/program/failure.hpp"
#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string failure(const std::string& text)
{
    try {
        read_text(text);
    } catch (const Failure& wrong) {
        return wrong.what();
    }
    return "";
}

}

TEST_CASE("failures name the line and the column")
{
    CHECK(failure("<canvas>\n  <layer></canvas>").starts_with("figure.sif:2:"));
    CHECK(failure("<svg/>").find("this is no file of Synfig") != std::string::npos);
    CHECK(failure("").starts_with("figure.sif:1:"));
    const std::string text =
        canvas("\n<layer type=\"circle\"><param name=\"radius\"><real value=\"big\"/></param></layer>");
    CHECK(failure(text).starts_with("figure.sif:2:"));
    CHECK(failure(text).find("\"big\" is no number") != std::string::npos);
}

TEST_CASE("a text of too many tags is a failure before they take any memory")
{
    CHECK(failure(std::string(2'097'152, '<')).find("this is no XML") != std::string::npos);
    CHECK(failure(std::string(2'097'153, '<')) ==
          "figure.sif: more than 2097152 tags: take something out of the file");
}

TEST_CASE("ids that are not there, and values that contain themselves, are failures")
{
    CHECK(failure(canvas("<layer type=\"circle\"><param name=\"radius\" use=\"size\"/></layer>"))
              .find("no value with the id \"size\"") != std::string::npos);
    CHECK(failure(canvas("<defs><add type=\"real\" id=\"a\" lhs=\"a\" rhs=\"a\"/></defs>"
                         "<layer type=\"circle\"><param name=\"radius\" use=\"a\"/></layer>"))
              .find("contains itself") != std::string::npos);
}

TEST_CASE("canvases that contain themselves are failures")
{
    CHECK(failure(
              canvas("<defs><canvas id=\"a\"><layer type=\"group\"><param name=\"canvas\" use=\"a\"/></layer>"
                     "<layer type=\"group\"><param name=\"canvas\" use=\"a\"/></layer></canvas></defs>"
                     "<layer type=\"group\"><param name=\"canvas\" use=\"a\"/></layer>")) != "");
}

TEST_CASE("absurd nesting and absurd numbers are failures")
{
    std::string open;
    std::string close;
    for (int i = 0; i < 100'000; ++i) {
        open += "<a>";
        close += "</a>";
    }
    CHECK(failure("<canvas>" + open + close + "</canvas>").find("deep in each other") != std::string::npos);
    CHECK(failure("<canvas width=\"1e9\"/>").find("out of range") != std::string::npos);
    CHECK(failure("<canvas view-box=\"0 0 0 0\"/>").find("view-box") != std::string::npos);
    CHECK(failure("<canvas view-box=\"1e-300 0 0 1\"/>").find("view-box") != std::string::npos);
    CHECK(failure("<canvas fps=\"nan\"/>") != "");
    CHECK(failure("<canvas end-time=\"9999999h\"/>") != "");
}

TEST_CASE("bones that hang on themselves are failures")
{
    const std::string bone =
        "<bone type=\"bone_object\" guid=\"A\"><parent><bone_valuenode guid=\"A\"/></parent></bone>";
    const std::string link =
        "<bone_link type=\"vector\"><bone><bone_valuenode guid=\"A\"/></bone><base_value>" +
        vector("0", "0") + "</base_value></bone_link>";
    CHECK(failure(canvas("<bones>" + bone + "</bones>" + layer("circle", parameter("origin", link))))
              .find("depends on itself") != std::string::npos);
}

TEST_CASE("long lines of bones are failures")
{
    std::string bones;
    for (int i = 0; i < 20'000; ++i)
        bones += "<bone type=\"bone_object\" guid=\"B" + std::to_string(i) +
                 "\"><parent><bone_valuenode guid=\"B" + std::to_string(i + 1) + "\"/></parent></bone>";
    const std::string link =
        "<bone_link type=\"vector\"><bone><bone_valuenode guid=\"B0\"/></bone><base_value>" +
        vector("0", "0") + "</base_value></bone_link>";
    CHECK(failure(canvas("<bones>" + bones + "</bones>" + layer("circle", parameter("origin", link)))) != "");
}

TEST_CASE("values beyond all measure stay finite")
{
    const std::string beyond =
        "<exp type=\"real\"><exp>" + real("1e9") + "</exp><scale>" + real("1") + "</scale></exp>";
    const auto nowhere =
        "<subtract type=\"real\"><lhs>" + beyond + "</lhs><rhs>" + beyond + "</rhs></subtract>";
    CHECK(failure(canvas(layer("star", parameter("points", beyond) + parameter("blend_method", beyond)))) ==
          "");
    CHECK(failure(canvas(layer("star", parameter("points", nowhere) + parameter("radius1", beyond)))) == "");
}

TEST_CASE("what repeats since all times repeats within the canvas only")
{
    const std::string step = "<step type=\"real\"><link>" + real("1") +
                             "</link><duration><time value=\"1s\"/></duration>"
                             "<start_time><time value=\"-1e30s\"/></start_time></step>";
    CHECK(failure(canvas(layer("circle", parameter("radius", step)))) == "");
}

TEST_CASE("the squares of a checker board go on however far its origin is away")
{
    const auto board = [](const std::string& x) {
        return read_layers(layer("checker_board", parameter("origin", vector(x, "0")) +
                                                      parameter("size", vector("0.5", "0.5"))));
    };
    const ReadFile near_board = board("0");
    const ReadFile far_board = board("-1000000000");
    const auto& near = near_board.shape().drawing.value().outlines;
    const auto& far = far_board.shape().drawing.value().outlines;
    REQUIRE(far.size() == near.size());
    CHECK(far[0].from.x == doctest::Approx(near[0].from.x));
}
