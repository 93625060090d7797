#include "core/math/affine.hpp"

#include "core/bytes/expects.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {

namespace {

constexpr std::int64_t max_half_width = Fixed::pixels(4095).raw();

/// Whether all factors are small, and the shift.
bool is_small(const Affine& map)
{
    return is_small_factor(map.xx) && is_small_factor(map.xy) && is_small_factor(map.yx) &&
           is_small_factor(map.yy) && map.x0 == static_cast<std::int32_t>(map.x0) &&
           map.y0 == static_cast<std::int32_t>(map.y0) &&
           is_small_distance(static_cast<std::int32_t>(map.x0)) &&
           is_small_distance(static_cast<std::int32_t>(map.y0));
}

/// The product of two small maps.
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
    return {.xx = clamped_factor(sum_of_products(outer.xx, inner.xx, outer.xy, inner.yx)),
            .xy = clamped_factor(sum_of_products(outer.xx, inner.xy, outer.xy, inner.yy)),
            .yx = clamped_factor(sum_of_products(outer.yx, inner.xx, outer.yy, inner.yx)),
            .yy = clamped_factor(sum_of_products(outer.yx, inner.xy, outer.yy, inner.yy)),
            .x0 = outer.x0 + sum_of_products(outer.xx, inner.x0, outer.xy, inner.y0),
            .y0 = outer.y0 + sum_of_products(outer.yx, inner.x0, outer.yy, inner.y0)};
}

Fixed half_width(Fixed width, std::int32_t scale_factor)
{
    expects(width >= Fixed{} && scale_factor >= 0);
    const std::int64_t raw = rounded_shift(std::int64_t{width.raw()} * scale_factor, 17);
    return Fixed::from_raw(static_cast<std::int32_t>(std::min(raw, max_half_width)));
}

namespace {

/// to / from in Q16, rounded to nearest; both are sides of canvases and panels.
std::int32_t ratio(int to, int from)
{
    const auto divisor = static_cast<std::uint32_t>(from);
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(to) * Fixed::one + divisor / 2) / divisor);
}

std::int32_t scale_for(Size canvas, Size panel, Fit fit)
{
    if (fit == Fit::none)
        return Fixed::one;
    const bool is_wider = canvas.width * panel.height > panel.width * canvas.height;
    return is_wider == (fit == Fit::contain) ? ratio(panel.width, canvas.width)
                                             : ratio(panel.height, canvas.height);
}

std::int64_t centring(int canvas, int panel, std::int32_t scale)
{
    return (std::int64_t{panel} * Fixed::one - std::int64_t{canvas} * scale) / 2;
}

}

Affine canvas_map(Size canvas, Size panel, Fit fit)
{
    const std::int32_t scale = scale_for(canvas, panel, fit);
    return {.xx = scale,
            .yy = scale,
            .x0 = centring(canvas.width, panel.width, scale),
            .y0 = centring(canvas.height, panel.height, scale)};
}

}
