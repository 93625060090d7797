#pragma once

#include "core/math/fixed.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

/// The corners of round caps and joins: angles are in 1/48 of a quarter turn.
namespace kfast::pen_arc {

/// sin(i / 48 of a quarter turn) in Q15.
inline constexpr std::array<std::uint16_t, 49> sines{
    0,     1072,  2143,  3212,  4277,  5338,  6393,  7441,  8481,  9512,  10533, 11543, 12540,
    13524, 14493, 15447, 16384, 17304, 18205, 19087, 19948, 20788, 21605, 22400, 23170, 23916,
    24636, 25330, 25997, 26635, 27246, 27827, 28378, 28899, 29389, 29847, 30274, 30668, 31029,
    31357, 31651, 31912, 32138, 32330, 32488, 32610, 32698, 32750, 32768};
inline constexpr int quarter_turn = 48;

inline std::int32_t sine_q15(int angle)
{
    return sines[static_cast<std::size_t>(angle <= quarter_turn ? angle : 2 * quarter_turn - angle)];
}

inline std::int32_t cosine_q15(int angle)
{
    return angle <= quarter_turn ? sine_q15(quarter_turn - angle) : -sine_q15(angle - quarter_turn);
}

inline constexpr std::int32_t arc_flatness = Fixed::one / 16;

/// The widest step in 1/48 quarter turn with which arcs stay within arc_flatness. A chord over the angle a of
/// a circle of radius r stays within r (1 - cos(a/2)), about r a^2 / 8; of pens wider than 600 px it is more.
inline int arc_step(Fixed half_width, int coarseness)
{
    constexpr std::array<std::uint8_t, 10> pieces{1, 2, 3, 4, 6, 8, 12, 16, 24, 48}; // of a quarter circle
    constexpr std::int32_t radius_of_one = arc_flatness * 16 / 5;                    // 32 / pi^2
    const std::int32_t radius = half_width.raw() >> 2 * coarseness;
    std::size_t chosen = 0;
    while (chosen + 1 < pieces.size() && pieces[chosen] * pieces[chosen] * radius_of_one < radius)
        ++chosen;
    return static_cast<int>(quarter_turn / std::uint32_t{pieces[chosen]});
}

/// Of the corners of an arc. Its ends are on the circle: beside them, arcs of wide pens have half chords. Of
/// thin ones a corner less is near enough.
constexpr int first_angle(int step)
{
    constexpr int wide = quarter_turn / 6;
    return step <= wide ? (step + 1) / 2 : step;
}

}
