#include "core/math/affine.hpp"

#include "core/player.hpp"
#include "core/scene/kfb_limits.hpp"
#include "tests/core/array_drawing.hpp"

#include <cstdlib>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr Size widest_canvas{kfb::max_canvas, 1};
constexpr Size largest_panel{Player::max_panel, Player::max_panel};

}

TEST_CASE("a panel of the canvas's size changes nothing, however the canvas is laid on it")
{
    for (const Fit fit : {Fit::contain, Fit::cover, Fit::none}) {
        const Affine map = canvas_map({240, 100}, {240, 100}, fit);
        CHECK(map(pixels(-3.25, 99.5)) == pixels(-3.25, 99.5));
        CHECK(half_width(Fixed::pixels(10), map.scale_factor()) == Fixed::pixels(5));
    }
}

TEST_CASE("contain scales by the tighter side and centres the other")
{
    const Affine wide = canvas_map({240, 120}, {120, 240}, Fit::contain);
    CHECK(wide(pixels(0, 0)) == pixels(0, 90));
    CHECK(wide(pixels(240, 120)) == pixels(120, 150));
    const Affine high = canvas_map({100, 200}, {400, 400}, Fit::contain);
    CHECK(high(pixels(0, 0)) == pixels(100, 0));
    CHECK(high(pixels(100, 200)) == pixels(300, 400));
}

TEST_CASE("cover scales by the looser side and cuts the other in equal parts")
{
    const Affine map = canvas_map({240, 120}, {120, 240}, Fit::cover);
    CHECK(map(pixels(120, 60)) == pixels(60, 120));
    CHECK(map(pixels(0, 0)) == pixels(-180, 0));
    CHECK(half_width(Fixed::pixels(6), map.scale_factor()) == Fixed::pixels(6));
}

TEST_CASE("none keeps the pixels and centres, cutting what is too large")
{
    const Affine map = canvas_map({240, 120}, {128, 200}, Fit::none);
    CHECK(map(pixels(0, 0)) == pixels(-56, 40));
    CHECK(half_width(Fixed::pixels(6), map.scale_factor()) == Fixed::pixels(3));
}

TEST_CASE("scale and lengths are rounded to nearest")
{
    const Affine two_thirds = canvas_map({3, 3}, {2, 2}, Fit::contain);
    CHECK(std::abs((half_width(Fixed::pixels(6), two_thirds.scale_factor()) - Fixed::pixels(2)).raw()) <= 1);
    const Affine half = canvas_map({4, 4}, {2, 2}, Fit::contain);
    CHECK(half_width(Fixed::from_raw(2), half.scale_factor()).raw() == 1);
    CHECK(half(pixels(1, 1) + Point{Fixed::from_raw(1), {}}) ==
          pixels(0.5, 0.5) + Point{Fixed::from_raw(1), {}});
}

TEST_CASE("the middle of any canvas is the middle of any panel")
{
    for (const Fit fit : {Fit::contain, Fit::cover, Fit::none}) {
        for (const Size canvas : {widest_canvas, Size{1, 1}, Size{1, kfb::max_canvas}, Size{240, 135}}) {
            for (const Size panel :
                 {largest_panel, Size{1, 1}, Size{4096, 1}, Size{1, 4096}, Size{128, 64}}) {
                const Point middle =
                    canvas_map(canvas, panel, fit)(pixels(canvas.width / 2.0, canvas.height / 2.0));
                const Point off = middle - pixels(panel.width / 2.0, panel.height / 2.0);
                CHECK(std::abs(off.x.raw()) <= 1);
                CHECK(std::abs(off.y.raw()) <= 1);
            }
        }
    }
}

TEST_CASE("what would not fit in Fixed stays at the limits")
{
    const Affine map = canvas_map(widest_canvas, largest_panel, Fit::cover);
    CHECK(map(pixels(0, -2048)) == pixels(-16383, -16383));
    CHECK(map(pixels(2047, 2047)) == pixels(16383, 16383));
    CHECK(half_width(Fixed::pixels(4094), map.scale_factor()) == Fixed::pixels(4095));
}

}
