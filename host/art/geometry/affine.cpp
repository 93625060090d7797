#include "host/art/geometry/affine.hpp"

#include <cmath>
#include <numbers>

namespace kfast::art {

scene::Outline Affine::of(const scene::Outline& outline) const
{
    scene::Outline result{of(outline.from), {}, outline.closed};
    result.curves.reserve(outline.curves.size());
    for (const scene::Curve& curve : outline.curves)
        result.curves.push_back(curve.cubic ? scene::cubic_to(of(curve.c1), of(curve.c2), of(curve.to))
                                            : scene::line_to(of(curve.to)));
    return result;
}

std::optional<Affine> Affine::inverse() const
{
    const double growth = determinant();
    if (!(std::abs(growth) > 1e-12) || !std::isfinite(growth))
        return std::nullopt;
    return Affine{d / growth, -b / growth, -c / growth, a / growth, 0, 0} * moved(-e, -f);
}

Affine turned(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    return {cosine, sine, -sine, cosine, 0, 0};
}

Affine skewed(double degrees, double axis)
{
    return turned(-axis) * Affine{1, 0, -std::tan(degrees * std::numbers::pi / 180), 1, 0, 0} * turned(axis);
}

}
