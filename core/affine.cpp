#include "core/affine.hpp"

#include "core/square_root.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int64_t furthest = Fixed::pixels(16383).raw();
constexpr std::int64_t widest = Fixed::pixels(4095).raw();

/// p a + q b in Q16, rounded to nearest, halves up. A factor 0 saves its product.
std::int64_t sum_of_products(std::int32_t p, std::int64_t a, std::int32_t q, std::int64_t b)
{
    std::int64_t sum = Fixed::one / 2;
    if (p != 0)
        sum += p * a;
    if (q != 0)
        sum += q * b;
    return sum >> 16;
}

std::int32_t factor(std::int64_t value)
{
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(value, -Affine::steepest, Affine::steepest));
}

Fixed near(std::int64_t raw)
{
    return Fixed::from_raw(static_cast<std::int32_t>(std::clamp(raw, -furthest, furthest)));
}

}

Point Affine::operator()(Point point) const
{
    return {near(sum_of_products(xx, point.x.raw(), xy, point.y.raw()) + x0),
            near(sum_of_products(yx, point.x.raw(), yy, point.y.raw()) + y0)};
}

std::int32_t Affine::growth() const
{
    if (xy == 0 && yx == 0 && std::abs(xx) == std::abs(yy))
        return std::abs(xx);
    const std::int64_t area = std::int64_t{xx} * yy - std::int64_t{xy} * yx;
    return static_cast<std::int32_t>(square_root(static_cast<std::uint64_t>(std::abs(area))));
}

Affine operator*(const Affine& outer, const Affine& inner)
{
    return {.xx = factor(sum_of_products(outer.xx, inner.xx, outer.xy, inner.yx)),
            .xy = factor(sum_of_products(outer.xx, inner.xy, outer.xy, inner.yy)),
            .yx = factor(sum_of_products(outer.yx, inner.xx, outer.yy, inner.yx)),
            .yy = factor(sum_of_products(outer.yx, inner.xy, outer.yy, inner.yy)),
            .x0 = outer.x0 + sum_of_products(outer.xx, inner.x0, outer.xy, inner.y0),
            .y0 = outer.y0 + sum_of_products(outer.yx, inner.x0, outer.yy, inner.y0)};
}

Fixed half_width(Fixed width, std::int32_t growth)
{
    const std::int64_t raw = (std::int64_t{width.raw()} * growth + Fixed::one) >> 17;
    return Fixed::from_raw(static_cast<std::int32_t>(std::min(raw, widest)));
}

}
