#include "host/art/geometry/drawing.hpp"
#include "host/geometry/shape.hpp"
#include "host/program/failure.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <string>
#include <vector>

using namespace kfast;
using scene::Vec2;

namespace {

art::Drawing line(double length)
{
    const std::array spots{Vec2{0, 0}, Vec2{length, 0}};
    return {{scene::polyline(spots, false)}};
}

/// Where dashes on the x axis begin and end: "0-5 10-15".
std::string dashes(const art::Drawing& drawing, const std::vector<double>& pattern, double offset = 0)
{
    art::Budget budget;
    std::string result;
    for (const scene::Outline& outline : art::dashed(drawing, pattern, offset, budget).outlines) {
        const Vec2 end = outline.curves.empty() ? outline.from : outline.curves.back().to;
        result += (result.empty() ? "" : " ") + std::to_string(std::lround(outline.from.x)) + '-' +
                  std::to_string(std::lround(end.x));
    }
    return result;
}

}

TEST_CASE("dashes and gaps take turns")
{
    CHECK(dashes(line(30), {5, 5}) == "0-5 10-15 20-25");
    CHECK(dashes(line(32), {5, 5}) == "0-5 10-15 20-25 30-32");
    CHECK(dashes(line(30), {10}) == "0-10 20-30");
    CHECK(dashes(line(60), {10, 5, 5}) == "0-10 15-20 30-35 40-50 55-60");
    CHECK(dashes(line(3), {5, 5}) == "0-3");
}

TEST_CASE("an offset begins within the pattern")
{
    CHECK(dashes(line(30), {5, 5}, 2) == "0-3 8-13 18-23 28-30");
    CHECK(dashes(line(30), {5, 5}, 5) == "5-10 15-20 25-30");
    CHECK(dashes(line(30), {5, 5}, -2) == "2-7 12-17 22-27");
    CHECK(dashes(line(30), {5, 5}, 1002) == "0-3 8-13 18-23 28-30");
}

TEST_CASE("a dash of no length is a dot")
{
    CHECK(dashes(line(25), {0, 10}) == "0-0 10-10 20-20");
    art::Budget budget;
    CHECK(art::dashed(line(25), std::array{0.0, 10.0}, 0, budget).outlines.front().closed);
}

TEST_CASE("without dashes, the drawing stays whole")
{
    CHECK(dashes(line(30), {}) == "0-30");
    CHECK(dashes(line(30), {0, 0}) == "0-30");
    art::Budget budget;
    const art::Drawing circle{{scene::ellipse({0, 0}, 10, 10)}};
    CHECK(art::dashed(circle, std::array{1000.0, 5.0}, 0, budget) == circle);
}

TEST_CASE("a closed outline goes on where it began")
{
    art::Budget budget;
    const art::Drawing square{{scene::rectangle({0, 0}, 10, 10, 0)}};
    const auto result = art::dashed(square, std::array{8.0, 4.0}, 2, budget);
    REQUIRE(result.outlines.size() == 3);
    CHECK(result.outlines.front().from.y == doctest::Approx(6)); // from 34 of 40, over the corner
    CHECK(result.outlines.front().curves.back().to.x == doctest::Approx(6));
    CHECK_FALSE(result.outlines.front().closed);
}

TEST_CASE("dashes on a curve lie on it, and are as long as they should be")
{
    art::Budget budget;
    const art::Drawing circle{{scene::ellipse({0, 0}, 100, 100)}};
    const auto result = art::dashed(circle, std::array{31.4159265, 31.4159265}, 0, budget);
    REQUIRE(result.outlines.size() == 10);
    for (const scene::Outline& dash : result.outlines) {
        CHECK(scene::distance({0, 0}, dash.curves.back().to) == doctest::Approx(100).epsilon(0.001));
        CHECK(scene::distance(dash.from, dash.curves.back().to) == doctest::Approx(31.287).epsilon(0.005));
    }
}

TEST_CASE("too many dashes are refused")
{
    art::Budget budget;
    CHECK_THROWS_AS(art::dashed(line(1e6), std::array{1e-9, 1e-9}, 0, budget), Failure);
    CHECK_THROWS_AS(art::dashed(line(1e6), std::array{std::numeric_limits<double>::denorm_min()}, 0, budget),
                    Failure);
}
