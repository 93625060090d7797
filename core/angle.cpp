#include "core/angle.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace kfast {
namespace {

/// Horner's scheme in Q30: coefficients from the lowest power, `at` in 0 … 1.
template <std::size_t count>
constexpr std::int32_t polynomial(const std::array<std::int32_t, count>& coefficients, std::int32_t at)
{
    std::int32_t sum = coefficients[count - 1];
    for (std::size_t i = count - 1; i-- > 0;)
        sum = coefficients[i] + multiply(sum, at, 30);
    return sum;
}

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
    return multiply(at, polynomial(sine_terms, static_cast<std::int32_t>((std::int64_t{at} * at) >> 30)), 30);
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

std::int32_t quarter_sine(Share share) { return quarter_sine(static_cast<std::int32_t>(share.raw << 14)); }

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

}
