#include "core/math/affine.hpp"

#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int64_t widest = Fixed::pixels(4095).raw();

/// Whether all of it is, and its shift.
bool is_small(const Affine& map)
{
    return is_small_factor(map.xx) && is_small_factor(map.xy) && is_small_factor(map.yx) &&
           is_small_factor(map.yy) && map.x0 == static_cast<std::int32_t>(map.x0) &&
           map.y0 == static_cast<std::int32_t>(map.y0) &&
           is_small_distance(static_cast<std::int32_t>(map.x0)) &&
           is_small_distance(static_cast<std::int32_t>(map.y0));
}

/// Of two small ones.
Affine short_product(const Affine& outer, const Affine& inner)
{
    const auto x0 = static_cast<std::int32_t>(inner.x0);
    const auto y0 = static_cast<std::int32_t>(inner.y0);
    return {.xx = short_sum_of_products(outer.xx, inner.xx, outer.xy, inner.yx),
            .xy = short_sum_of_products(outer.xx, inner.xy, outer.xy, inner.yy),
            .yx = short_sum_of_products(outer.yx, inner.xx, outer.yy, inner.yx),
            .yy = short_sum_of_products(outer.yx, inner.xy, outer.yy, inner.yy),
            .x0 = outer.x0 + short_sum_of_products(outer.xx, x0, outer.xy, y0),
            .y0 = outer.y0 + short_sum_of_products(outer.yx, x0, outer.yy, y0)};
}

}

Point Affine::operator()(Point point) const
{
    return clamped_point(sum_of_products(xx, point.x.raw(), xy, point.y.raw()) + x0,
                         sum_of_products(yx, point.x.raw(), yy, point.y.raw()) + y0);
}

std::int32_t Affine::scale_factor() const
{
    if (xy == 0 && yx == 0 && std::abs(xx) == std::abs(yy))
        return std::abs(xx);
    const std::int64_t area = std::int64_t{xx} * yy - std::int64_t{xy} * yx;
    return static_cast<std::int32_t>(square_root(static_cast<std::uint64_t>(std::abs(area))));
}

Affine operator*(const Affine& outer, const Affine& inner)
{
    if (is_small(outer) && is_small(inner)) // mostly
        return short_product(outer, inner);
    return {.xx = held_factor(sum_of_products(outer.xx, inner.xx, outer.xy, inner.yx)),
            .xy = held_factor(sum_of_products(outer.xx, inner.xy, outer.xy, inner.yy)),
            .yx = held_factor(sum_of_products(outer.yx, inner.xx, outer.yy, inner.yx)),
            .yy = held_factor(sum_of_products(outer.yx, inner.xy, outer.yy, inner.yy)),
            .x0 = outer.x0 + sum_of_products(outer.xx, inner.x0, outer.xy, inner.y0),
            .y0 = outer.y0 + sum_of_products(outer.yx, inner.x0, outer.yy, inner.y0)};
}

Fixed half_width(Fixed width, std::int32_t scale_factor)
{
    const std::int64_t raw = (std::int64_t{width.raw()} * scale_factor + Fixed::one) >> 17;
    return Fixed::from_raw(static_cast<std::int32_t>(std::min(raw, widest)));
}

}
