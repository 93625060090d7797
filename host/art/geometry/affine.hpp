#pragma once

#include "host/geometry/outline.hpp"

#include <numbers>
#include <optional>

namespace kfast::art {

/// One degree in radians.
inline constexpr double degree = std::numbers::pi / 180;

/// Maps (x, y) to (a x + c y + e, b x + d y + f), the order of SVG's matrix(a b c d e f).
struct Affine {
    double a = 1;
    double b = 0;
    double c = 0;
    double d = 1;
    double e = 0;
    double f = 0;

    constexpr scene::Vec2 of(scene::Vec2 spot) const
    {
        return {a * spot.x + c * spot.y + e, b * spot.x + d * spot.y + f};
    }
    scene::Outline of(const scene::Outline& outline) const;
    constexpr double determinant() const { return a * d - b * c; }

    /// The inverse map. Nothing if it is singular.
    std::optional<Affine> inverse() const;

    friend bool operator==(const Affine&, const Affine&) = default;
};

/// First `inner`, then `outer`.
constexpr Affine operator*(const Affine& outer, const Affine& inner)
{
    return {outer.a * inner.a + outer.c * inner.b,           outer.b * inner.a + outer.d * inner.b,
            outer.a * inner.c + outer.c * inner.d,           outer.b * inner.c + outer.d * inner.d,
            outer.a * inner.e + outer.c * inner.f + outer.e, outer.b * inner.e + outer.d * inner.f + outer.f};
}

constexpr Affine moved(double x, double y) { return {1, 0, 0, 1, x, y}; }
constexpr Affine grown(double x, double y) { return {x, 0, 0, y, 0, 0}; }
/// A rotation, clockwise on the screen.
Affine turned(double degrees);
/// The skew of a Transform: rotated by the axis, sheared so that what is higher goes right, rotated back.
Affine skewed(double degrees, double axis);

}
