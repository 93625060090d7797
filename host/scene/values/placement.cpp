#include "host/scene/values/placement.hpp"

#include "core/math/angle.hpp"

namespace kfast::scene {
namespace {

double value_of(const ItemValues& values, Property property, std::int32_t ordinary, double unit)
{
    return values.get(property).value_or(ordinary) / unit;
}

}

Placement::Placement(const ItemValues& values)
    : origin_{value_of(values, Property::x, 0, 16), value_of(values, Property::y, 0, 16)}
{
    const auto angle = BinaryAngle::from_raw(values.get(Property::rotation).value_or(0));
    const Vec2 direction{static_cast<double>(cosine(angle)) / one_q30,
                         static_cast<double>(sine(angle)) / one_q30};
    x_axis_ = value_of(values, Property::scale_x, scale_one, scale_one) * direction;
    y_axis_ = value_of(values, Property::scale_y, scale_one, scale_one) * Vec2{-direction.y, direction.x};
}

Vec2 Placement::of(Vec2 spot) const { return origin_ + spot.x * x_axis_ + spot.y * y_axis_; }

Outline Placement::of(const Outline& outline) const
{
    Outline placed{.from = of(outline.from), .curves = {}, .closed = outline.closed};
    placed.curves.reserve(outline.curves.size());
    for (const Curve& curve : outline.curves)
        placed.curves.push_back(curve.cubic ? cubic_to(of(curve.c1), of(curve.c2), of(curve.to))
                                            : line_to(of(curve.to)));
    return placed;
}

}
