#pragma once

#include "core/math/point.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace kfast {

/// What lies further away from the origin in x or y, in whole pixels, is moved there: so far that differences
/// fit in Fixed.
inline constexpr std::int32_t farthest_held = 16383;
/// The same for what is yet to be tweened by ways that may lead beyond 0 … 1 (core/math/fixed.hpp).
inline constexpr std::int32_t farthest_tweened = 4095;

/// What a coordinate is computed in: 64 bits if 32 may not be enough.
template <class T>
concept Coordinate = std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t>;

template <Coordinate Number>
constexpr Fixed held(Number raw, std::int32_t farthest = farthest_held)
{
    const Number limit = Fixed::pixels(farthest).raw();
    return Fixed::from_raw(static_cast<std::int32_t>(std::clamp(raw, static_cast<Number>(-limit), limit)));
}

/// `x` and `y` are in 1/65536 px.
template <Coordinate Number>
constexpr Point held_point(Number x, Number y, std::int32_t farthest = farthest_held)
{
    return {held(x, farthest), held(y, farthest)};
}

}
