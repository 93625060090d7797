#include "core/canvas_map.hpp"

#include "tests/core/array_drawing.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a panel of the canvas's size changes nothing, however the canvas is laid on it")
{
    for (const Fit fit : {Fit::contain, Fit::cover, Fit::none}) {
        const CanvasMap map{{240, 100}, {240, 100}, fit};
        CHECK(map(pixels(-3.25, 99.5)) == pixels(-3.25, 99.5));
        CHECK(map.scaled(Fixed::pixels(5)) == Fixed::pixels(5));
    }
}

TEST_CASE("contain scales by the tighter side and centres the other")
{
    const CanvasMap wide{{240, 120}, {120, 240}, Fit::contain};
    CHECK(wide(pixels(0, 0)) == pixels(0, 90));
    CHECK(wide(pixels(240, 120)) == pixels(120, 150));
    const CanvasMap high{{100, 200}, {400, 400}, Fit::contain};
    CHECK(high(pixels(0, 0)) == pixels(100, 0));
    CHECK(high(pixels(100, 200)) == pixels(300, 400));
}

TEST_CASE("cover scales by the looser side and cuts the other in equal parts")
{
    const CanvasMap map{{240, 120}, {120, 240}, Fit::cover};
    CHECK(map(pixels(120, 60)) == pixels(60, 120));
    CHECK(map(pixels(0, 0)) == pixels(-180, 0));
    CHECK(map.scaled(Fixed::pixels(3)) == Fixed::pixels(6));
}

TEST_CASE("none keeps the pixels and centres, cutting what is too large")
{
    const CanvasMap map{{240, 120}, {128, 200}, Fit::none};
    CHECK(map(pixels(0, 0)) == pixels(-56, 40));
    CHECK(map.scaled(Fixed::pixels(3)) == Fixed::pixels(3));
}

TEST_CASE("what lies too far away is held at 16383 px")
{
    const CanvasMap map{{1, 1}, {4096, 4096}, Fit::contain};
    CHECK(map(pixels(2047, -2048)) == pixels(16383, -16383));
    CHECK(map.scaled(Fixed::pixels(2047)) == Fixed::pixels(16383));
}

}
