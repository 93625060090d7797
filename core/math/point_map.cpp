// PointMap: an Affine for each point of an outline, hence compiled for speed; affine.cpp is for each item.

#include "core/math/affine.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <cstdlib>

namespace kfast {

namespace {

/// Of |x| and |y| before a shift, and of the shift: their sum need not be held.
constexpr std::int32_t small_shift = Fixed::pixels(max_coordinate / 2).raw();

constexpr bool is_within(std::int64_t value, std::int32_t limit) { return value > -limit && value < limit; }

}

PointMap::PointMap(const Affine& map) : map_{map}, kind_{Kind::any}
{
    if (!is_within(map.x0, small_shift) || !is_within(map.y0, small_shift))
        return;
    if (map.xx == Fixed::one && map.yy == Fixed::one && map.xy == 0 && map.yx == 0)
        kind_ = Kind::shift;
    else if (is_small_factor(map.xx) && is_small_factor(map.xy) && is_small_factor(map.yx) &&
             is_small_factor(map.yy))
        kind_ = Kind::small;
}

Point PointMap::shift() const
{
    return {Fixed::from_raw(static_cast<std::int32_t>(map_.x0)),
            Fixed::from_raw(static_cast<std::int32_t>(map_.y0))};
}

Point PointMap::operator()(Point point) const
{
    const std::int32_t x = point.x.raw();
    const std::int32_t y = point.y.raw();
    const auto x0 = static_cast<std::int32_t>(map_.x0);
    const auto y0 = static_cast<std::int32_t>(map_.y0);
    if (kind_ == Kind::shift && is_within(x, small_shift) && is_within(y, small_shift))
        return {Fixed::from_raw(x + x0), Fixed::from_raw(y + y0)};
    const bool is_short = kind_ == Kind::small && is_small_distance(x) && is_small_distance(y);
    count_op(is_short ? Op::point : Op::wide_point);
    if (is_short)
        return {clamped(short_sum_of_products(map_.xx, x, map_.xy, y) + x0),
                clamped(short_sum_of_products(map_.yx, x, map_.yy, y) + y0)};
    return map_(point);
}

}
