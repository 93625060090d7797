#include "host/geometry/unit_circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::scene {
namespace {

/// `spot` moved along the tangent of the unit circle, clockwise.
Vec2 moved(Vec2 spot, double along) { return spot + along * Vec2{-spot.y, spot.x}; }

}

Vec2 on_unit_circle(double degrees)
{
    int quarters = 0; // its last three bits, with the sign of `degrees`
    const double rest = std::remquo(degrees, 90.0, &quarters) * std::numbers::pi / 180;
    Vec2 spot{std::cos(rest), std::sin(rest)};
    for (int i = quarters & 3; i > 0; --i)
        spot = {-spot.y, spot.x};
    return spot;
}

int arc_pieces(double quarters)
{
    // A quarter that rounding made a hair too long is still one piece.
    return std::max(1, static_cast<int>(std::ceil(quarters - 1e-9)));
}

Curve unit_arc(Vec2 from, Vec2 to, double radians)
{
    const double handle = 4.0 / 3.0 * std::tan(radians / 4);
    return cubic_to(moved(from, handle), moved(to, -handle), to);
}

}
