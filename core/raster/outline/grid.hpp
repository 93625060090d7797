#pragma once

#include "core/math/point.hpp"
#include "core/math/quotient.hpp"

#include <cstdint>

namespace kfast::raster {

/// Outlines lie on a grid of 1/64 px. Their coordinates are integers in this unit: x to the right of the
/// panel's left border, y below its upper one.
inline constexpr int grid_bits = 6;
inline constexpr std::int32_t grid = 1 << grid_bits;

/// The first column, or row, at or before a coordinate.
constexpr int floor_pixel(std::int32_t coordinate) { return coordinate >> grid_bits; }
/// The first border between columns, or rows, at or behind a coordinate.
constexpr int ceil_pixel(std::int32_t coordinate) { return (coordinate + grid - 1) >> grid_bits; }
/// Whether it lies on such a border.
constexpr bool is_on_border(std::int32_t coordinate) { return (coordinate & (grid - 1)) == 0; }

/// What lies at part / whole of the way between two coordinates, rounded to nearest; 0 <= part <= whole, and
/// both are less than 2^23.
constexpr std::int32_t interpolate(std::int32_t from, std::int32_t to, std::int32_t part, std::int32_t whole)
{
    const std::int64_t way = std::int64_t{to - from} * part;
    return from + static_cast<std::int32_t>(
                      quotient(2 * way + (way < 0 ? -whole : whole), 2 * static_cast<std::uint32_t>(whole)));
}

/// A corner of an outline made of straight lines. |x| and |y| are at most 2^21.
struct Corner {
    std::int32_t x = 0;
    std::int32_t y = 0;

    friend constexpr bool operator==(Corner, Corner) = default;
};

/// The corner nearest to a point, halves to the right and down.
constexpr Corner corner_at(Point point)
{
    constexpr int bits = 16 - grid_bits;
    const auto rounded = [](Fixed coordinate) {
        return (coordinate.raw() >> bits) + (coordinate.raw() >> (bits - 1) & 1);
    };
    return {rounded(point.x), rounded(point.y)};
}

}
