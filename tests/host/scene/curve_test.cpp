#include "tests/host/scene/cubic.hpp"
#include "tests/host/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

Exact mix(Exact a, Exact b, double from, double to, double at)
{
    const double share = (at - from) / (to - from);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The pyramid of Barry and Goldman: between p[1] and p[2], at `share` of the way between their knots.
Exact on_spline(const std::array<Exact, 4>& p, double share)
{
    std::array<double, 4> knot{};
    for (std::size_t i = 1; i < 4; ++i)
        knot[i] = knot[i - 1] + std::pow(std::hypot(p[i].x - p[i - 1].x, p[i].y - p[i - 1].y), 0.5);
    const double at = knot[1] + share * (knot[2] - knot[1]);
    std::array<Exact, 4> level = p;
    for (std::size_t size = 1; size <= 2; ++size)
        for (std::size_t i = 0; i + size < 4; ++i)
            level[i] = mix(level[i], level[i + 1], knot[i], knot[i + size], at);
    return mix(level[0], level[1], knot[1], knot[2], at);
}

scene::Stroke curve_through(const std::vector<Exact>& spots, const std::string& properties)
{
    std::string node = "curve";
    for (const Exact spot : spots)
        node += ' ' + std::to_string(spot.x) + ' ' + std::to_string(spot.y);
    const auto text = read_on_canvas("object o fill=red { " + node + properties + " }");
    REQUIRE(text.findings == "");
    return key_at(*text.scene).drawing.strokes.at(0);
}

const std::vector<Exact> uneven{{0, 0}, {100, 10}, {104, 30}, {90, 90}, {91, 91}, {0, 60}};

double distance(Exact a, Exact b) { return std::hypot(a.x - b.x, a.y - b.y); }

}

TEST_CASE("a closed curve is a centripetal Catmull-Rom spline")
{
    const scene::Stroke stroke = curve_through(uneven, " closed=#true");
    const std::size_t count = uneven.size();
    REQUIRE(stroke.segments.size() == count);
    scene::Point from = stroke.from;
    for (std::size_t i = 0; i < count; ++i) {
        const std::array around{uneven[(i + count - 1) % count], uneven[i], uneven[(i + 1) % count],
                                uneven[(i + 2) % count]};
        for (const double share : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0})
            CHECK(distance(on_cubic(from, stroke.segments[i], share), on_spline(around, share)) < 1.0 / 16);
        from = stroke.segments[i].to;
    }
}

TEST_CASE("an open curve is the same but for its first and last piece")
{
    const scene::Stroke open = curve_through(uneven, "");
    const scene::Stroke closed = curve_through(uneven, " closed=#true");
    REQUIRE(open.segments.size() == uneven.size() - 1);
    for (std::size_t i = 1; i + 2 < uneven.size(); ++i)
        CHECK(open.segments[i] == closed.segments[i]);
    CHECK(open.segments.front() != closed.segments.front());
    CHECK(open.segments.back().to == scene::Point{0, 960});
}

TEST_CASE("the ends of an open curve are parabolas")
{
    CHECK(drawn("curve 0 0 16 16 32 0") ==
          "M 0 0 C 5.3125 10.6875 10.6875 16 16 16 C 21.3125 16 26.6875 10.6875 32 0");
    CHECK(drawn("curve 0 0 16 0 16 16 0 16") == "M 0 0 C 8 -2.6875 13.3125 -2.6875 16 0"
                                                " C 18.6875 2.6875 18.6875 13.3125 16 16"
                                                " C 13.3125 18.6875 8 18.6875 0 16");
}

TEST_CASE("a curve through two points is a line, through one a point")
{
    CHECK(drawn("curve 1 2 16 7") == "M 1 2 L 16 7");
    CHECK(drawn("curve 1 2 16 7 closed=#true") == "M 1 2 L 16 7 L 1 2");
    CHECK(drawn("curve 1 2 1 2") == "M 1 2");
    CHECK(drawn("curve 1 2 1 2 closed=#true") == "M 1 2");
}

TEST_CASE("repeated points of a curve count once")
{
    const std::string curve = drawn("curve 0 0 16 16 32 0");
    CHECK(drawn("curve 0 0 0 0 16 16 16 16 32 0 32 0") == curve);
    CHECK(drawn("curve 0 0 16 16 1e-300 1e-300 0 0 32 0") == drawn("curve 0 0 16 16 0 0 32 0"));
    const std::string closed = drawn("curve 0 0 16 16 32 0 closed=#true");
    CHECK(closed != curve);
    CHECK(drawn("curve 0 0 16 16 32 0 0 0 0 0 closed=#true") == closed);
    CHECK(drawn("curve 0 0 16 16 32 0 closed=#false") == curve);
}

TEST_CASE("curves of another form are refused")
{
    CHECK(drawn("curve 1 2") == "1:1 error: curve needs more values (write curve X Y X Y … closed=#true)");
    CHECK(drawn("curve 1 2 3 4 5") == "1:15 error: this x has no y (add the y, or remove this x)");
    CHECK(drawn("curve 1 2 3 4 closed=yes") == "1:22 error: #true or #false is expected here");
    CHECK(drawn("curve 1 2 3 4 closed=(s)#true") ==
          "1:22 error: this value takes no type or unit (leave out (s))");
    CHECK(drawn("curve 1 2 3 4 close=#true") ==
          "1:15 error: curve has no property \"close\" (did you mean \"closed\"?)");
    CHECK(drawn("curve 2047 0 2047 9 0 4 2047 -2047") ==
          "1:1 error: this curve reaches more than 2047 px from the origin");
}

}
