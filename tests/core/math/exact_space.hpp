#pragma once

#include "tests/core/spot.hpp"

#include <cmath>
#include <numbers>

/// Turns in space and perspective, by the words of docs/format.md.
namespace kfast::test {

/// In pixels.
struct Place {
    double x;
    double y;
    double z;
};

/// What the tracks of an item say, in pixels, turns and factors.
struct ItemValues {
    Place position{0, 0, 0};
    Spot pivot{0, 0};
    Spot scale{1, 1};
    double turns_x = 0;
    double turns_y = 0;
    double turns = 0;

    /// position + pivot + Rx(Ry(Rz(scale(p - pivot))))
    Place operator()(Place p) const
    {
        const double full = 2 * std::numbers::pi;
        p = {(p.x - pivot.x) * scale.x, (p.y - pivot.y) * scale.y, p.z};
        turn(turns * full, p.x, p.y);   // x towards y
        turn(turns_y * full, p.z, p.x); // z towards x
        turn(turns_x * full, p.y, p.z); // y towards z
        return {position.x + pivot.x + p.x, position.y + pivot.y + p.y, position.z + p.z};
    }

private:
    static void turn(double angle, double& from, double& towards)
    {
        const double before = from;
        from = std::cos(angle) * from - std::sin(angle) * towards;
        towards = std::sin(angle) * before + std::cos(angle) * towards;
    }
};

/// How a viewer at the distance `distance` from the canvas, opposite to `middle`, sees a place.
inline Spot seen(Place p, Spot middle, double distance)
{
    const double near = distance / (distance - p.z);
    return {middle.x + near * (p.x - middle.x), middle.y + near * (p.y - middle.y)};
}

}
