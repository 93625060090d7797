#include "core/chain_edge.hpp"

namespace kfast {
namespace {

/// Rounded towards minus infinity, for divisor > 0.
template <class T>
T floor_divide(T dividend, std::int32_t divisor)
{
    const T quotient = dividend / divisor;
    return quotient - (quotient * divisor > dividend ? 1 : 0);
}

constexpr std::int32_t short_way = (1 << 20) - 1; ///< times 1024, and half a height, it fits in 32 bits

/// slope * subrow / 1024, rounded down.
std::int32_t way_down(std::int32_t slope, std::int32_t part)
{
    if (part <= subrows && slope >= -short_way && slope <= short_way)
        return slope * part >> 10;
    return static_cast<std::int32_t>(std::int64_t{slope} * part >> 10);
}

}

Fixed ChainEdge::x_at(std::int32_t subrow, std::int32_t slope) const
{
    const std::int32_t part = subrow - upper->y;
    const std::int32_t whole = height();
    if (part == whole)
        return lower->x;
    if (whole >= subrows)
        return upper->x + Fixed::from_raw(way_down(slope, part));
    const std::int32_t way = (lower->x - upper->x).raw(); // divided in 32 bits: less than a row is left
    if (way >= -short_way && way <= short_way)
        return upper->x + Fixed::from_raw(floor_divide(way * part, whole));
    return upper->x + Fixed::from_raw(way / whole * part + floor_divide(way % whole * part, whole));
}

std::int32_t row_slope(const ChainEdge& edge)
{
    const std::int64_t way = std::int64_t{edge.lower->x.raw()} - edge.upper->x.raw();
    const std::int32_t half = edge.height() / 2;
    if (way >= -short_way && way <= short_way)
        return floor_divide<std::int32_t>(static_cast<std::int32_t>(way) * subrows + half, edge.height());
    return static_cast<std::int32_t>(floor_divide<std::int64_t>(way * subrows + half, edge.height()));
}

}
