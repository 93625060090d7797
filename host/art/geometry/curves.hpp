#pragma once

#include "host/geometry/outline.hpp"

#include <array>

namespace kfast::art {

/// A cubic Bézier by itself: where it begins, its control points, where it ends.
struct CubicPiece {
    std::array<scene::Vec2, 4> points;

    /// The point at a parameter from 0 to 1.
    scene::Vec2 at(double parameter) const;
    /// The part between two parameters; those may be outside of 0 to 1.
    CubicPiece between(double from, double to) const;
    scene::Vec2 chord() const { return points[3] - points[0]; }
    /// The derivatives by the parameter at its beginning and its end.
    scene::Vec2 first_slope() const { return 3.0 * (points[1] - points[0]); }
    scene::Vec2 last_slope() const { return 3.0 * (points[3] - points[2]); }
    /// Its directions at the beginning and at the end: not 0 unless it has no extent.
    scene::Vec2 first_direction() const;
    scene::Vec2 last_direction() const;
};

/// How far apart the two are at most at the same parameter; never too little.
double distance(const CubicPiece& left, const CubicPiece& right);

/// Fits a cubic whose ends are given, by least squares.
class CubicFit {
public:
    CubicFit(scene::Vec2 from, scene::Vec2 to) : from_{from}, to_{to} {}

    /// Adds a sample: the point at a parameter from 0 to 1 is to be near `spot`.
    void take(double parameter, scene::Vec2 spot, double weight);

    /// With any handles.
    CubicPiece free() const;
    /// With handles in given directions, which are not 0.
    CubicPiece along(scene::Vec2 first, scene::Vec2 last) const;

private:
    scene::Vec2 from_;
    scene::Vec2 to_;
    double first_ = 0;
    double both_ = 0;
    double last_ = 0;
    scene::Vec2 towards_first_;
    scene::Vec2 towards_last_;
};

/// The length of a curve from `from`, in pixels: accurate to 1/100,000 except at sharp turns.
double curve_length(scene::Vec2 from, const scene::Curve& curve);

/// The parameter, 0 to 1, of its point at a length from its beginning; its ends beyond them.
double curve_parameter(scene::Vec2 from, const scene::Curve& curve, double length);

/// The point of the curve at a parameter, 0 to 1.
scene::Vec2 spot_on(scene::Vec2 from, const scene::Curve& curve, double t);

/// The length of an outline without the line that closes it.
double outline_length(const scene::Outline& outline);

/// The point at a fraction of the length of an outline with at least one curve; its ends beyond 0 and 1.
scene::Vec2 spot_along(const scene::Outline& outline, double share);

}
