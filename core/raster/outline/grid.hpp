#pragma once

#include "core/bytes/expects.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// Outlines are on a grid of 1/64 px. Their coordinates are integers in this unit: x to the right of the
/// panel's left border, y below its upper one.
inline constexpr int grid_bits = 6;
inline constexpr std::int32_t grid = 1 << grid_bits;

/// The first column, or row, at or before a coordinate.
constexpr int floor_pixel(std::int32_t coordinate) { return coordinate >> grid_bits; }
/// The first border between columns, or rows, at or after a coordinate.
constexpr int ceil_pixel(std::int32_t coordinate) { return (coordinate + grid - 1) >> grid_bits; }
/// Whether a coordinate is on such a border.
constexpr bool is_on_border(std::int32_t coordinate) { return (coordinate & (grid - 1)) == 0; }

/// The value at part / whole between two coordinates, rounded to nearest; 0 <= part <= whole, and
/// both are less than 2^23.
constexpr std::int32_t interpolate(std::int32_t from, std::int32_t to, std::int32_t part, std::int32_t whole)
{
    expects(part >= 0 && part <= whole && whole >= 1 && whole < 1 << 23);
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

/// 65536 / i for i = 2 … 256, rounded to nearest; 65535 for 0 and 1. A Cortex-M0 has no division.
inline constexpr std::array<std::uint16_t, 257> reciprocals = [] {
    std::array<std::uint16_t, 257> table{};
    table[0] = table[1] = 65535;
    for (std::uint32_t i = 2; i < table.size(); ++i)
        table[i] = static_cast<std::uint16_t>((65536 + i / 2) / i);
    return table;
}();

/// How far an edge moves to the right over each row, in 1/1024 of the grid: 65536 width / rise, but for the
/// rounding of reciprocals. |width| is at most 32767, `rise` 1 … 65471.
inline std::int32_t slope_of(std::int32_t width, std::int32_t rise)
{
    if (rise <= 256)
        return width * reciprocals[static_cast<std::size_t>(rise)];
    int shift = 2; // rise / 2^shift has 7 or 8 bits
    while (rise >> shift > 255)
        ++shift;
    const std::int32_t inverse = reciprocals[static_cast<std::size_t>(rise >> shift)];
    const std::int32_t slope = (width * inverse) >> shift;
    // The remainder of the width, over the same rise: a step of Newton's division.
    const auto rest =
        static_cast<std::int32_t>((static_cast<std::uint32_t>(width) << 16) -
                                  static_cast<std::uint32_t>(slope) * static_cast<std::uint32_t>(rise));
    return slope + ((((rest >> 6) * inverse) >> 10) >> shift);
}

/// Where an edge crosses the first border of a row, `height` below x, in 1/1024 of the grid and rounded to
/// its nearest; each further one is a slope further to the right.
constexpr std::int32_t first_crossing(std::int32_t x, std::int32_t slope, std::int32_t height)
{
    return (x << 10) + 512 + (slope >> grid_bits) * height;
}

/// Shows whether two layers have the same outlines: 64 bits of the corners of all contours in their order, or
/// of what they are made of. Others that agree in them would be taken for the same; one of 1.8e19 pairs does.
class Fingerprint {
public:
    void add(std::int32_t first, std::int32_t second)
    {
        const auto a = static_cast<std::uint32_t>(first);
        const auto b = static_cast<std::uint32_t>(second);
        // Two independent multiplicative hashes (as FNV-1a, on words): odd factors lose nothing.
        high_ = (high_ ^ a) * 0x9E37'79B1U + b;
        low_ = (low_ ^ b) * 0x85EB'CA77U + a;
        high_ ^= high_ >> 15;
        low_ ^= low_ >> 13;
    }
    void add(std::span<const Corner> contour)
    {
        for (const Corner& corner : contour)
            add(corner.x, corner.y);
        high_ = (high_ + 1) * 0xC2B2'AE3DU;
        low_ = (low_ ^ 1) * 0x27D4'EB2FU;
    }

    friend constexpr bool operator==(Fingerprint, Fingerprint) = default;

private:
    // Not 0, which corners at the origin would leave as it is.
    std::uint32_t high_ = 0x6A09'E667;
    std::uint32_t low_ = 0xBB67'AE85;
};

}
