#include "core/raster/outline/object_outline.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/raster/outline/chain_lines.hpp"

#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {
namespace {

constexpr Size panel{16, 16};

/// What is stored of a stroke, and the memory that it took meanwhile.
struct Stored {
    std::vector<ChainLine> lines;
    std::size_t bytes;

    explicit Stored(const OwnedOutlines& outlines)
        : lines{lines_of(outlines.store())}, bytes{outlines.store().needed_bytes()}
    {
    }
    friend bool operator==(const Stored&, const Stored&) = default;
};

Stored filled(const std::vector<Point>& points, Point hub)
{
    OwnedOutlines outlines{panel};
    FillOutline outline{outlines.store()};
    outline.begin(points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
        outline.line_to(points[i]);
    outline.end(hub);
    return Stored{outlines};
}

/// The corners of one contour, each told once.
Stored contour(const std::vector<raster::Corner>& corners)
{
    OwnedOutlines outlines{panel};
    outlines.add(corners);
    REQUIRE(!lines_of(outlines.store()).empty());
    return Stored{outlines};
}

raster::Corner corner(double x, double y) { return raster::corner_at(pixels(x, y)); }

}

TEST_CASE("a fill goes from corner to corner and back to the first, whether the stroke is closed or not")
{
    const Stored triangle = contour({corner(1, 1), corner(9, 2), corner(3, 7)});
    CHECK(filled({pixels(1, 1), pixels(9, 2), pixels(3, 7)}, pixels(1, 1)) == triangle);
    CHECK(filled({pixels(1, 1), pixels(9, 2), pixels(3, 7), pixels(1, 1)}, pixels(1, 1)) == triangle);
}

TEST_CASE("a part of a broken stroke is closed by way of its hub")
{
    CHECK(filled({pixels(1, 1), pixels(9, 2), pixels(3, 7)}, pixels(5, 5)) ==
          contour({corner(1, 1), corner(9, 2), corner(3, 7), corner(5, 5)}));
}

TEST_CASE("points that fall on one corner are told once")
{
    const Point near{pixels(9, 2).x, pixels(9, 2).y + Fixed::from_raw(511)};
    CHECK(filled({pixels(1, 1), pixels(9, 2), near, pixels(3, 7), pixels(3, 7)}, pixels(3, 7)) ==
          contour({corner(1, 1), corner(9, 2), corner(3, 7)}));
}

TEST_CASE("corners lie on the nearest point of the grid, halves to the right and down")
{
    const auto rounded = [](std::int32_t raw) {
        const raster::Corner corner = raster::corner_at({Fixed::from_raw(raw), Fixed::from_raw(raw)});
        CHECK(corner.x == corner.y);
        return corner.y;
    };
    CHECK(rounded(511) == 0);
    CHECK(rounded(512) == 1);
    CHECK(rounded(-512) == 0);
    CHECK(rounded(-513) == -1);
    CHECK(rounded(Fixed::pixels(-16383).raw()) == -16383 * raster::grid);
}

}
