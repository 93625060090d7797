#pragma once

#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <cstdint>

namespace kfast {

/// A direction in 1/65536 turn, clockwise on the screen; 0 points along x. Sums wrap.
struct BinaryAngle {
    std::uint16_t raw = 0;

    static constexpr std::int32_t turn = 65536;
    static constexpr std::int32_t half_turn = turn / 2;
    static constexpr std::int32_t quarter_turn = turn / 4;

    /// `raw` is taken modulo one turn.
    static constexpr BinaryAngle from_raw(std::int32_t raw) { return {static_cast<std::uint16_t>(raw)}; }

    friend constexpr bool operator==(BinaryAngle, BinaryAngle) = default;
};

/// A direction in 1/2^32 turn, clockwise on the screen. Sums wrap.
struct FineAngle {
    std::uint32_t raw = 0;

    static constexpr FineAngle of(BinaryAngle angle) { return {std::uint32_t{angle.raw} << 16}; }
    /// `turns` is in 1/2^24 turn, the unit in which angles of tracks are computed (1/256 of 1/65536).
    static constexpr FineAngle of_fine(std::int32_t turns)
    {
        return {static_cast<std::uint32_t>(turns) << 8};
    }

    friend constexpr bool operator==(FineAngle, FineAngle) = default;
    friend constexpr FineAngle operator+(FineAngle a, FineAngle b) { return {a.raw + b.raw}; }
};

/// The smallest rotation from `from` to `to` in 1/65536 turn, -32768 … 32767, positive clockwise.
constexpr std::int32_t shortest_turn(BinaryAngle from, BinaryAngle to)
{
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(to.raw - from.raw));
}

/// One in Q30, the format of sines and of the components of unit vectors.
inline constexpr std::int32_t one_q30 = 1 << 30;

/// sin(fraction * 90 degrees) in Q30, within 16 units of the exact value, monotone, exact at both ends.
std::int32_t quarter_sine(Fraction fraction);

/// sin(angle) in Q30, within 16 units of the exact value.
std::int32_t sine(FineAngle angle);
std::int32_t cosine(FineAngle angle);
inline std::int32_t sine(BinaryAngle angle) { return sine(FineAngle::of(angle)); }
inline std::int32_t cosine(BinaryAngle angle) { return cosine(FineAngle::of(angle)); }

/// The x axis rotated by an angle, in Q30.
struct UnitVector {
    std::int32_t cosine = one_q30;
    std::int32_t sine = 0;
};

/// Q16 from Q30, for example a component of a unit vector; rounded to nearest, halves up.
constexpr std::int32_t q16_of_q30(std::int32_t value) { return rounded_shift(value, 14); }

/// The direction of the vector (x, y), within 1 unit of the exact value; 0 for the vector (0, 0).
/// |x| and |y| are less than 2^31.
BinaryAngle direction(std::int32_t x, std::int32_t y);

/// A direction as a unit vector in Q15, within 1/15000 rad: products of two of these fit in 32 bits.
struct Direction {
    std::int32_t x = 0;
    std::int32_t y = 0;
};

/// A direction and a length.
struct PolarVector {
    Direction direction;
    std::uint32_t length = 0; ///< in 1/65536 px, within 1/5000 of it
};

/// `vector` is not (0, 0).
PolarVector to_polar(Point vector);

}
