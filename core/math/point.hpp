#pragma once

#include "core/math/fixed.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace kfast {

/// A point or a vector in pixels: x to the right, y down.
struct Point {
    Fixed x;
    Fixed y;

    friend constexpr bool operator==(Point, Point) = default;
    friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Point operator-(Point a) { return {-a.x, -a.y}; }
};

/// The length of the vector (x, y), or up to 1/8 more; it fits.
constexpr std::int32_t rough_length(std::int32_t x, std::int32_t y)
{
    const std::int32_t width = x < 0 ? -x : x;
    const std::int32_t height = y < 0 ? -y : y;
    return std::max(width, height) + std::min(width, height) / 2;
}

/// lerp() of Fixed, the same for x and y.
constexpr Point lerp(Point a, Point b, Fraction fraction)
{
    return {lerp(a.x, b.x, fraction), lerp(a.y, b.y, fraction)};
}

/// lerp() with separate progress for x and y.
constexpr Point lerp(Point a, Point b, Progress x, Progress y)
{
    return {lerp(a.x, b.x, x), lerp(a.y, b.y, y)};
}

/// x and y are clamped to this distance from the origin, in whole pixels: then their differences fit in
/// Fixed.
inline constexpr std::int32_t max_coordinate = 16383;
/// The same for what is yet to be tweened by progress that may be beyond 0 … 1 (core/math/fixed.hpp).
inline constexpr std::int32_t max_tweened_coordinate = 4095;

/// A type that coordinates are computed in: 64 bits if 32 may not be enough.
template <class T>
concept Coordinate = std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t>;

template <Coordinate Number>
constexpr Fixed clamped(Number raw, std::int32_t farthest = max_coordinate)
{
    const Number limit = Fixed::pixels(farthest).raw();
    return Fixed::from_raw(static_cast<std::int32_t>(std::clamp(raw, static_cast<Number>(-limit), limit)));
}

/// `x` and `y` are in 1/65536 px.
template <Coordinate Number>
constexpr Point clamped_point(Number x, Number y, std::int32_t farthest = max_coordinate)
{
    return {clamped(x, farthest), clamped(y, farthest)};
}

/// Width and height in whole pixels.
struct Size {
    int width = 0;
    int height = 0;
    friend constexpr bool operator==(Size, Size) = default;
};

/// A rectangle of whole pixels; x and y are its left upper corner.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

}
