#pragma once

#include "core/math/fixed.hpp"

#include <algorithm>
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

/// As lerp() of Fixed, for x and y alike.
constexpr Point lerp(Point a, Point b, Share share) { return {lerp(a.x, b.x, share), lerp(a.y, b.y, share)}; }

/// With separate ways for x and y.
constexpr Point lerp(Point a, Point b, Way x, Way y) { return {lerp(a.x, b.x, x), lerp(a.y, b.y, y)}; }

}
