#include "core/fill_outline.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/winding.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The corners of one contour; the first is told once more at its end.
std::vector<Corner> filled(const std::vector<Point>& points, Point hub)
{
    Contours contours;
    FillOutline outline{contours.store()};
    outline.begin(points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
        outline.line_to(points[i]);
    outline.end(hub);
    return contours.corners();
}

Corner corner(double x, double y) { return corner_at(pixels(x, y)); }

}

TEST_CASE("a fill goes from corner to corner and back to the first, whether the stroke is closed or not")
{
    const std::vector<Corner> triangle{corner(1, 1), corner(9, 2), corner(3, 7), corner(1, 1)};
    CHECK(filled({pixels(1, 1), pixels(9, 2), pixels(3, 7)}, pixels(1, 1)) == triangle);
    CHECK(filled({pixels(1, 1), pixels(9, 2), pixels(3, 7), pixels(1, 1)}, pixels(1, 1)) == triangle);
}

TEST_CASE("a part of a broken stroke is closed by way of its hub")
{
    CHECK(filled({pixels(1, 1), pixels(9, 2), pixels(3, 7)}, pixels(5, 5)) ==
          std::vector{corner(1, 1), corner(9, 2), corner(3, 7), corner(5, 5), corner(1, 1)});
}

TEST_CASE("points that fall on one corner are told once")
{
    const Point near{pixels(9, 2).x, pixels(9, 2).y + Fixed::from_raw(31)};
    CHECK(filled({pixels(1, 1), pixels(9, 2), near, pixels(3, 7), pixels(3, 7)}, pixels(3, 7)) ==
          std::vector{corner(1, 1), corner(9, 2), corner(3, 7), corner(1, 1)});
}

TEST_CASE("corners lie on the nearest sub-row, halves on the lower one")
{
    const auto y_of = [](std::int32_t raw) { return corner_at({{}, Fixed::from_raw(raw)}).y; };
    CHECK(y_of(31) == 0);
    CHECK(y_of(32) == 1);
    CHECK(y_of(-32) == 0);
    CHECK(y_of(-33) == -1);
    CHECK(y_of(Fixed::pixels(-16383).raw()) == -16383 * subrows);
}

}
