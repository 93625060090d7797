#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string point(const std::string& x, const std::string& width)
{
    return "<entry><composite type=\"bline_point\"><point>" + vector(x, "0") + "</point><width>" +
           real(width) + "</width><t1>" + vector("0.5", "0") + "</t1></composite></entry>";
}

ReadFile outline(const std::string& first, const std::string& last, const std::string& more = "")
{
    return read_layers(
        layer("outline", parameter("bline", "<bline type=\"bline_point\" loop=\"false\">" +
                                                point("-1", first) + point("1", last) + "</bline>") +
                             parameter("width", real("0.2")) + more));
}

}

TEST_CASE("an outline of one width is a line")
{
    const ReadFile file = outline("1", "1");
    REQUIRE(file.shape().stroke);
    CHECK_FALSE(file.shape().fill);
    CHECK(file.shape().stroke->width.value() == doctest::Approx(10));
    CHECK(file.shape().stroke->cap == Cap::round);
    CHECK_FALSE(file.shape().drawing.value().outlines.at(0).closed);
}

TEST_CASE("its ends are flat if both tips are")
{
    const std::string flat = "<bool value=\"false\"/>";
    const ReadFile file =
        outline("1", "1", parameter("round_tip[0]", flat) + parameter("round_tip[1]", flat));
    CHECK(file.shape().stroke->cap == Cap::butt);
}

TEST_CASE("an outline whose width varies is the shape that it covers")
{
    const ReadFile file = outline("0.5", "2");
    REQUIRE(file.shape().fill);
    CHECK_FALSE(file.shape().stroke);
    const auto& shape = file.shape().drawing.value().outlines.at(0);
    CHECK(shape.closed);
    double min = 100;
    double max = 0;
    for (const auto& curve : shape.curves) {
        min = std::min(min, curve.to.y);
        max = std::max(max, curve.to.y);
    }
    CHECK(min == doctest::Approx(40).epsilon(0.01));
    CHECK(max == doctest::Approx(60).epsilon(0.01));
}
