#include "core/math/angle.hpp"

#include "core/bytes/expects.hpp"
#include "core/math/polynomial.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace kfast {

namespace {

// Both polynomials interpolate at Chebyshev nodes in the square of the argument. The lowest coefficient of
// the sine is adjusted so that they add up to 1: the quarter turn is exact.

/// sin(pi/2 * u) / u as a polynomial in u^2.
constexpr std::array<std::int32_t, 5> sine_terms{1686629699, -693598305, 85566398, -5018824, 162856};

/// atan(u) / u as a polynomial in u^2, in turns.
constexpr std::array<std::int32_t, 7> arctangent_terms{170891187, -56950691, 33959592, -22981232,
                                                       14205589,  -6213682,  1307037};

/// atan(ratio) in 1/65536 turn for a ratio in Q15, 0 … 1.
std::int32_t arctangent(std::int32_t ratio)
{
    return multiply(ratio, polynomial(arctangent_terms, ratio * ratio), 29);
}

/// sin(at * 90 degrees) in Q30 for `at` in Q30, 0 … 1.
std::int32_t quarter_sine(std::int32_t at)
{
    return product_q30(at, polynomial(sine_terms, product_q30(at, at)));
}

/// smaller / larger in Q15 for 0 <= smaller <= larger, larger > 0.
std::int32_t ratio_q15(std::uint32_t smaller, std::uint32_t larger)
{
    const int excess = std::max(0, 16 - std::countl_zero(larger));
    const std::uint32_t divisor = larger >> excess;
    return static_cast<std::int32_t>(std::min(((smaller >> excess) << 15) + divisor / 2, divisor << 15) /
                                     divisor);
}

}

std::int32_t quarter_sine(Fraction fraction)
{
    return quarter_sine(static_cast<std::int32_t>(fraction.raw << 14));
}

std::int32_t sine(FineAngle angle)
{
    constexpr std::uint32_t half_turn = 1U << 31;
    const std::uint32_t within_half = angle.raw & (half_turn - 1);
    const std::uint32_t size = std::min(within_half, half_turn - within_half);
    const std::int32_t quarter = quarter_sine(static_cast<std::int32_t>(size));
    return angle.raw < half_turn ? quarter : -quarter;
}

std::int32_t cosine(FineAngle angle) { return sine(FineAngle{angle.raw + (1U << 30)}); }

BinaryAngle direction(std::int32_t x, std::int32_t y)
{
    const auto width = static_cast<std::uint32_t>(x < 0 ? -x : x);
    const auto height = static_cast<std::uint32_t>(y < 0 ? -y : y);
    if (width == 0 && height == 0)
        return {};
    std::int32_t angle = width >= height ? arctangent(ratio_q15(height, width))
                                         : BinaryAngle::quarter_turn - arctangent(ratio_q15(width, height));
    if (x < 0)
        angle = BinaryAngle::half_turn - angle;
    return BinaryAngle::from_raw(y < 0 ? -angle : angle);
}

namespace {

/// 2^30 / sqrt(square) for 2^28 … 2^31, at most 1/16000 off.
std::uint32_t inverse_root(std::uint32_t square)
{
    const bool is_large = square >= 1U << 30;
    const std::uint32_t reduced = (is_large ? square : square << 2) >> 16;
    // The line is within 9 % of 2^31 / sqrt for all that is left; each of Newton's steps squares the error.
    std::uint32_t root = 69888 - (reduced * 39 >> 6);
    for (int step = 0; step < 3; ++step) {
        const auto rest = (1 << 30) - static_cast<std::int32_t>(reduced * (root * root >> 16));
        root += static_cast<std::uint32_t>((static_cast<std::int32_t>(root) * (rest >> 15)) >> 16);
    }
    return is_large ? root >> 1 : root;
}

}

// The vector is brought to 15 bits, so that its square fits in 32. Its direction is then within 1/30000 rad,
// and so is what rounding the unit vector adds: together 1/750 px at the edge of a stroke 40 px wide.
PolarVector to_polar(Point vector)
{
    expects(vector != Point{});
    const auto longest =
        static_cast<std::uint32_t>(std::max(std::abs(vector.x.raw()), std::abs(vector.y.raw())));
    const int excess = 17 - std::countl_zero(longest);
    const auto shifted = [excess](std::int32_t value) {
        return excess > 0 ? rounded_shift(value, excess) : value * (1 << -excess);
    };
    const std::int32_t x = shifted(vector.x.raw());
    const std::int32_t y = shifted(vector.y.raw());
    const auto square = static_cast<std::uint32_t>(x * x) + static_cast<std::uint32_t>(y * y);
    const auto inverse = static_cast<std::int32_t>(inverse_root(square));
    const auto unit = [inverse](std::int32_t value) { return rounded_shift(value * inverse, 15); };
    const std::uint32_t length = (square >> 15) * static_cast<std::uint32_t>(inverse) >> 15;
    return {{unit(x), unit(y)}, excess > 0 ? length << excess : length >> -excess};
}

}
