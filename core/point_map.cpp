#include "core/point_map.hpp"

#include "core/held_point.hpp"
#include "core/work.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// Of |x| and |y| before a shift, and of the shift: their sum need not be held.
constexpr std::int32_t modest_shift = Fixed::pixels(farthest_held / 2).raw();
/// Of |x| and |y| before a modest map, 1024 px, and of its factors, 8.
constexpr std::int32_t modest_reach = 1 << 26;
constexpr std::int32_t modest_factor = 1 << 19;

constexpr bool is_within(std::int64_t value, std::int32_t limit) { return value > -limit && value < limit; }

/// As sum_of_products() where that fits in 32 bits.
std::int32_t short_sum_of_products(std::int32_t p, std::int32_t a, std::int32_t q, std::int32_t b)
{
    constexpr std::uint32_t low_half = 0xFFFF;
    const auto low = [](std::int32_t value) { return static_cast<std::uint32_t>(value) & low_half; };
    const auto high = [](std::int32_t value) { return static_cast<std::uint32_t>(value >> 16); };
    const std::uint64_t rest = std::uint64_t{low(p) * low(a)} + low(q) * low(b) + Fixed::one / 2;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(p) * high(a) + high(p) * low(a) +
                                     static_cast<std::uint32_t>(q) * high(b) + high(q) * low(b) +
                                     static_cast<std::uint32_t>(rest >> 16));
}

Fixed held_short(std::int32_t raw)
{
    constexpr std::int32_t limit = Fixed::pixels(farthest_held).raw();
    return Fixed::from_raw(std::clamp(raw, -limit, limit));
}

}

PointMap::PointMap(const Affine& map) : map_{map}, kind_{Kind::any}
{
    if (!is_within(map.x0, modest_shift) || !is_within(map.y0, modest_shift))
        return;
    if (map.xx == Fixed::one && map.yy == Fixed::one && map.xy == 0 && map.yx == 0)
        kind_ = Kind::shift;
    else if (is_within(map.xx, modest_factor) && is_within(map.xy, modest_factor) &&
             is_within(map.yx, modest_factor) && is_within(map.yy, modest_factor))
        kind_ = Kind::modest;
}

Point PointMap::operator()(Point point) const
{
    const std::int32_t x = point.x.raw();
    const std::int32_t y = point.y.raw();
    const auto x0 = static_cast<std::int32_t>(map_.x0);
    const auto y0 = static_cast<std::int32_t>(map_.y0);
    if (kind_ == Kind::shift && is_within(x, modest_shift) && is_within(y, modest_shift))
        return {Fixed::from_raw(x + x0), Fixed::from_raw(y + y0)};
    const bool is_short = kind_ == Kind::modest && is_within(x, modest_reach) && is_within(y, modest_reach);
    did(is_short ? Work::point : Work::wide_point);
    if (is_short)
        return {held_short(short_sum_of_products(map_.xx, x, map_.xy, y) + x0),
                held_short(short_sum_of_products(map_.yx, x, map_.yy, y) + y0)};
    return map_(point);
}

}
