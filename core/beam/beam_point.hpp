#pragma once

#include "core/pixel/colour.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace kfast {

/// A place in the field, the square that the beam of a vector display can reach: 65536 units wide and high,
/// x to the right, y up, (0, 0) in the middle, as in ILDA's files. A DAC of n bits has 2^(16 - n) units a
/// step. Aligned so that small processors copy it as a word, not by a call.
struct alignas(4) FieldPoint {
    std::int16_t x = 0;
    std::int16_t y = 0;

    friend constexpr bool operator==(FieldPoint, FieldPoint) = default;
};

inline constexpr std::int32_t field_side = 65536;
inline constexpr std::int32_t field_min = -32768;
inline constexpr std::int32_t field_max = 32767;

/// How far a beam travels from `a` to `b`: by the longer of its two ways, as both of its mirrors, coils or
/// pairs of plates move at once.
constexpr std::int32_t beam_travel(FieldPoint a, FieldPoint b)
{
    const std::int32_t x = a.x - b.x;
    const std::int32_t y = a.y - b.y;
    return std::max(x < 0 ? -x : x, y < 0 ? -y : y);
}

/// A way within the field.
struct FieldVector {
    std::int32_t x = 0; ///< within ±65535, as y
    std::int32_t y = 0;

    /// In units of the field: not less than it is, and up to 1/200 and a unit more. Exact along the axes.
    ///
    /// A way is as long as the longest of its shadows in all directions. Of 32 directions all around, one is
    /// always within 5.625 degrees, so that the longest shadow divided by the cosine of that is not too
    /// short. That takes a fifth of the time of a square root.
    std::uint32_t length() const
    {
        const auto width = static_cast<std::uint32_t>(std::abs(x));
        const auto height = static_cast<std::uint32_t>(std::abs(y));
        const std::uint32_t more = std::max(width, height);
        const std::uint32_t less = std::min(width, height);
        constexpr std::uint32_t whole = 1U << 14;
        std::uint32_t longest = whole * more + 1614 * less; // 5.625 degrees, and so on every 11.25
        longest = std::max(longest, 15755 * more + 4780 * less);
        longest = std::max(longest, 14520 * more + 7761 * less);
        longest = std::max(longest, 12727 * more + 10445 * less);
        return (longest + whole - 1) / whole;
    }
};

constexpr FieldVector operator-(FieldPoint to, FieldPoint from) { return {to.x - from.x, to.y - from.y}; }

/// Where the beam is for one tick of the point clock, and how it shines.
struct BeamPoint {
    FieldPoint at;
    Colour colour = {.opacity = 0}; ///< black with an opacity of 0 where the beam is blanked, else opaque

    constexpr bool is_lit() const { return colour.opacity != 0; }
    friend constexpr bool operator==(const BeamPoint&, const BeamPoint&) = default;
};

}
