#include "core/canvas_map.hpp"

#include "core/kfb_limits.hpp"
#include "core/player.hpp"
#include "tests/core/array_drawing.hpp"

#include <cstdlib>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr Size widest_canvas{kfb::max_canvas, 1};
constexpr Size largest_panel{Player::max_panel, Player::max_panel};

}

TEST_CASE("contain, cover and none lay the canvas on the panel, centred")
{
    const auto corner = [](Fit fit) { return CanvasMap{{40, 20}, {80, 80}, fit}(pixels(40, 20)); };
    CHECK(corner(Fit::contain) == pixels(80, 60));
    CHECK(corner(Fit::cover) == pixels(120, 80));
    CHECK(corner(Fit::none) == pixels(60, 50));
}

TEST_CASE("the middle of any canvas is the middle of any panel")
{
    for (const Fit fit : {Fit::contain, Fit::cover, Fit::none}) {
        for (const Size canvas : {widest_canvas, Size{1, 1}, Size{1, kfb::max_canvas}, Size{240, 135}}) {
            for (const Size panel :
                 {largest_panel, Size{1, 1}, Size{4096, 1}, Size{1, 4096}, Size{128, 64}}) {
                const Point middle =
                    CanvasMap{canvas, panel, fit}(pixels(canvas.width / 2.0, canvas.height / 2.0));
                const Point off = middle - pixels(panel.width / 2.0, panel.height / 2.0);
                CHECK(std::abs(off.x.raw()) <= 1);
                CHECK(std::abs(off.y.raw()) <= 1);
            }
        }
    }
}

TEST_CASE("what would not fit in Fixed stays at the limits")
{
    const CanvasMap map{widest_canvas, largest_panel, Fit::cover};
    CHECK(map(pixels(0, -2048)) == pixels(-16383, -16383));
    CHECK(map(pixels(2047, 2047)) == pixels(16383, 16383));
    CHECK(map.half_width(Fixed::pixels(2047)) == Fixed::pixels(4095));
}

}
