#pragma once

#include "core/raster/outline/grid.hpp"

#include <array>
#include <cstdint>

namespace kfast::raster {

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
    // What is left of the width, over the same rise: a step of Newton's division.
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

}
