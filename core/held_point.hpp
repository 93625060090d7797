#pragma once

#include "core/point.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// What lies further away from the origin in x or y, in whole pixels, is moved there: so far that differences
/// fit in Fixed.
inline constexpr std::int32_t farthest_held = 16383;
/// The same for what is yet to be tweened by ways that may lead beyond 0 … 1 (core/fixed.hpp).
inline constexpr std::int32_t farthest_tweened = 4095;

constexpr Fixed held(std::int64_t raw, std::int32_t farthest = farthest_held)
{
    const std::int64_t limit = Fixed::pixels(farthest).raw();
    return Fixed::from_raw(static_cast<std::int32_t>(std::clamp(raw, -limit, limit)));
}

/// Likewise for what fits in 32 bits.
constexpr Fixed held_short(std::int32_t raw)
{
    constexpr std::int32_t limit = Fixed::pixels(farthest_held).raw();
    return Fixed::from_raw(std::clamp(raw, -limit, limit));
}

/// `x` and `y` are in 1/65536 px.
constexpr Point held_point(std::int64_t x, std::int64_t y, std::int32_t farthest = farthest_held)
{
    return {held(x, farthest), held(y, farthest)};
}

}
