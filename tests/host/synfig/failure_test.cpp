#include "host/failure.hpp"
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
