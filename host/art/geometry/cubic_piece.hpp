#pragma once

#include "host/geometry/outline.hpp"

#include <array>

namespace kfast::art {

/// A cubic Bézier by itself: where it begins, its control points, where it ends.
struct CubicPiece {
    std::array<scene::Vec2, 4> points;

    /// At a parameter from 0 to 1.
    scene::Vec2 at(double parameter) const;
    /// Between two parameters; those may lie outside of 0 to 1.
    CubicPiece between(double from, double to) const;
    scene::Vec2 chord() const { return points[3] - points[0]; }
    /// By its parameter, where it begins and ends.
    scene::Vec2 first_slope() const { return 3.0 * (points[1] - points[0]); }
    scene::Vec2 last_slope() const { return 3.0 * (points[3] - points[2]); }
    /// Where it sets out for, where it comes from: not 0 unless it has no extent.
    scene::Vec2 first_direction() const;
    scene::Vec2 last_direction() const;
};

/// How far apart the two are at most at the same parameter; never too little.
double distance(const CubicPiece& left, const CubicPiece& right);

}
