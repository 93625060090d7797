#include "host/art/geometry/convex_polygon.hpp"
#include "host/geometry/shape.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

using namespace kfast;
using scene::Vec2;

namespace {

art::Drawing box(double left, double top, double right, double bottom)
{
    return {{scene::rectangle({left, top}, right - left, bottom - top, 0)}};
}

art::Drawing polygon(std::span<const Vec2> corners) { return {{scene::polyline(corners, true)}}; }

/// The area of all, each outline in chords.
double area(const art::Drawing& drawing)
{
    double doubled = 0;
    for (const scene::Outline& outline : drawing.outlines) {
        Vec2 from = outline.from;
        const auto go = [&](Vec2 to) {
            doubled += cross(from, to);
            from = to;
        };
        for (const scene::Curve& curve : outline.curves) {
            const scene::Curve cubic = art::as_cubic(from, curve);
            const Vec2 begin = from;
            for (int i = 1; i <= 100; ++i) {
                const double t = i / 100.0;
                const double rest = 1 - t;
                go(rest * rest * rest * begin + 3 * rest * rest * t * cubic.c1 + 3 * rest * t * t * cubic.c2 +
                   t * t * t * cubic.to);
            }
        }
        go(outline.from);
    }
    return std::abs(doubled) / 2;
}

}

TEST_CASE("a convex polygon is one whose corners lie on one side of each side")
{
    CHECK(art::ConvexPolygon::of(box(0, 0, 10, 10)));
    CHECK(art::ConvexPolygon::of(polygon(std::array{Vec2{0, 0}, Vec2{0, 9}, Vec2{9, 0}})));
    CHECK_FALSE(art::ConvexPolygon::of(polygon(std::array{Vec2{0, 0}, Vec2{9, 0}, Vec2{2, 2}, Vec2{0, 9}})));
    CHECK_FALSE(art::ConvexPolygon::of(
        polygon(std::array{Vec2{0, -10}, Vec2{6, 8}, Vec2{-10, -3}, Vec2{10, -3}, Vec2{-6, 8}})));
    CHECK_FALSE(art::ConvexPolygon::of({{scene::ellipse({0, 0}, 5, 5)}}));
    CHECK_FALSE(art::ConvexPolygon::of(box(0, 0, 10, 0)));
    CHECK_FALSE(art::ConvexPolygon::of({}));
}

TEST_CASE("curves are cut where they cross its sides")
{
    const auto half = art::ConvexPolygon::of(box(0, -20, 20, 20));
    REQUIRE(half);
    const art::Drawing circle{{scene::ellipse({0, 0}, 10, 10)}};
    CHECK(area(half->cut(circle)) == doctest::Approx(area(circle) / 2).epsilon(1e-3));
    const auto quarter = art::ConvexPolygon::of(box(20, 20, 0, 0));
    REQUIRE(quarter);
    CHECK(area(quarter->cut(circle)) == doctest::Approx(area(circle) / 4).epsilon(1e-3));
    CHECK(half->cut(circle).outlines.at(0).closed);
}

TEST_CASE("what lies inside stays as it is, what lies outside goes")
{
    const auto window = art::ConvexPolygon::of(box(0, 0, 10, 10));
    REQUIRE(window);
    CHECK(area(window->cut(box(2, 2, 8, 8))) == doctest::Approx(36));
    const art::Drawing same = window->cut(box(0, 0, 10, 10));
    CHECK(area(same) == doctest::Approx(100));
    CHECK(same.outlines.at(0).curves.size() == 4);
    CHECK(window->cut(box(11, 2, 18, 8)).outlines.empty());
    CHECK(area(window->cut(box(-10, -10, 20, 20))) == doctest::Approx(100).epsilon(1e-3));
    const std::array spots{Vec2{1, 1}, Vec2{9, 9}};
    CHECK(window->contains(spots, 1));
    CHECK_FALSE(window->contains(spots, 2));
    const std::array beyond{Vec2{12, 1}, Vec2{14, 9}};
    CHECK(window->misses(beyond, 1));
    CHECK_FALSE(window->misses(beyond, 3));
}
