#pragma once

#include "core/bytes/expects.hpp"

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

namespace kfast {

/// (high * 2^32 + low) / divisor, rounded down, for high < divisor: then it has 32 bits.
///
/// Two digits of 16 bits, each estimated from the highest 16 bits of the divisor and at most two too large
/// (Knuth, The Art of Computer Programming, volume 2, 4.3.1, algorithm D). The functions that compilers call
/// for 64-bit divisions take ten times the code on processors of 32 bits.
constexpr std::uint32_t long_quotient(std::uint32_t high, std::uint32_t low, std::uint32_t divisor)
{
    expects(high < divisor);
    const int shift = std::countl_zero(divisor);
    const std::uint32_t whole = divisor << shift;
    const std::uint32_t upper = whole >> 16;
    const std::uint32_t lower = whole & 0xFFFF;
    const std::uint64_t dividend = (std::uint64_t{high} << 32 | low) << shift;
    auto rest = static_cast<std::uint32_t>(dividend >> 32);
    low = static_cast<std::uint32_t>(dividend);
    std::uint32_t quotient = 0;
    for (int digits = 0; digits < 2; ++digits) {
        std::uint32_t digit = rest / upper;
        std::uint32_t left = rest - digit * upper;
        while (digit > 0xFFFF || digit * lower > (left << 16 | low >> 16)) {
            --digit;
            left += upper;
            if (left > 0xFFFF)
                break;
        }
        rest = (rest << 16 | low >> 16) - digit * whole;
        quotient = quotient << 16 | digit;
        low <<= 16;
    }
    return quotient;
}

/// Rounded down; `divisor` is at least 1.
[[gnu::noinline]] constexpr std::uint64_t quotient(std::uint64_t dividend, std::uint32_t divisor)
{
    expects(divisor >= 1);
    const auto high = static_cast<std::uint32_t>(dividend >> 32);
    const auto low = static_cast<std::uint32_t>(dividend);
    const std::uint32_t above = high == 0 ? 0 : high / divisor;
    const std::uint32_t rest = high - above * divisor;
    return std::uint64_t{above} << 32 | long_quotient(rest, low, divisor);
}

/// Rounded towards 0.
constexpr std::int64_t quotient(std::int64_t dividend, std::uint32_t divisor)
{
    const bool is_negative = dividend < 0;
    const auto size = static_cast<std::uint64_t>(dividend);
    const auto whole = static_cast<std::int64_t>(quotient(is_negative ? 0 - size : size, divisor));
    return is_negative ? -whole : whole;
}

/// dividend - divisor * quotient(dividend, divisor)
constexpr std::uint32_t remainder(std::uint64_t dividend, std::uint32_t divisor)
{
    return static_cast<std::uint32_t>(dividend - quotient(dividend, divisor) * divisor);
}

/// A fraction of a whole, 0 … 1, in Q16: 65536 is the whole.
struct Fraction {
    std::uint32_t raw = 0;

    static constexpr std::uint32_t one = 65536;

    /// numerator / denominator for 0 <= numerator <= denominator, rounded to nearest, halves up.
    /// `denominator` is at least 1.
    static constexpr Fraction ratio(std::uint32_t numerator, std::uint32_t denominator)
    {
        expects(numerator <= denominator && denominator >= 1);
        if (numerator < 0x4000) // keeps the division in 32 bits
            return {((numerator << 16) + denominator / 2) / denominator};
        const std::uint64_t scaled = (std::uint64_t{numerator} << 16) + denominator / 2;
        return {static_cast<std::uint32_t>(quotient(scaled, denominator))};
    }

    friend constexpr auto operator<=>(Fraction, Fraction) = default;
};

/// The progress from one key to the next in Q16: 65536 is at the next. Velocity laws may overshoot at both
/// ends, within -1.5 … 2.5.
struct Progress {
    std::int32_t raw = 0;

    static constexpr std::int32_t one = 65536;

    friend constexpr auto operator<=>(Progress, Progress) = default;
};

/// A length in pixels in Q16.16: 1/65536 px, -32768 … 32767 px. Sums and differences do not check their
/// range.
class Fixed {
public:
    constexpr Fixed() = default;
    static constexpr Fixed from_raw(std::int32_t raw) { return Fixed{raw}; }
    /// `count` is within -32768 … 32767.
    static constexpr Fixed pixels(std::int32_t count)
    {
        expects(count >= -32768 && count <= 32767);
        return Fixed{count * one};
    }
    /// The unit in which scenes store coordinates; `count` is within -524288 … 524287.
    static constexpr Fixed sixteenths(std::int32_t count)
    {
        expects(count >= -524288 && count <= 524287);
        return Fixed{count * (one / 16)};
    }

    static constexpr std::int32_t one = 65536;

    constexpr std::int32_t raw() const { return raw_; }

    friend constexpr auto operator<=>(Fixed, Fixed) = default;
    friend constexpr Fixed operator+(Fixed a, Fixed b) { return Fixed{a.raw_ + b.raw_}; }
    friend constexpr Fixed operator-(Fixed a, Fixed b) { return Fixed{a.raw_ - b.raw_}; }
    friend constexpr Fixed operator-(Fixed a) { return Fixed{-a.raw_}; }

private:
    constexpr explicit Fixed(std::int32_t raw) : raw_{raw} {}

    std::int32_t raw_ = 0;
};

/// value / 2^bits, rounded to nearest, halves up. `bits` is at least 1, and value + 2^(bits - 1) fits in the
/// type.
template <std::integral T>
constexpr T rounded_shift(T value, int bits)
{
    expects(bits >= 1 && bits < std::numeric_limits<T>::digits);
    return (value + (T{1} << (bits - 1))) >> bits;
}

/// value * factor / 2^bits, rounded to nearest, halves up. `bits` is 1 … 62 and the result fits.
constexpr std::int32_t multiply(std::int32_t value, std::int32_t factor, int bits)
{
    expects(bits >= 1 && bits <= 62);
    const std::int64_t half = std::int64_t{1} << (bits - 1);
    return static_cast<std::int32_t>((std::int64_t{value} * factor + half) >> bits);
}

/// Like multiply() with 16 bits. Small processors multiply 32 bits in a cycle, but call a function for 64.
constexpr std::int32_t multiply_q16(std::int32_t value, std::int32_t factor)
{
    constexpr std::uint32_t low_half = 0xFFFF;
    const auto fraction = static_cast<std::uint32_t>(factor) & low_half;
    const std::uint32_t low = (static_cast<std::uint32_t>(value) & low_half) * fraction + low_half / 2 + 1;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) *
                                         static_cast<std::uint32_t>(factor >> 16) +
                                     static_cast<std::uint32_t>(value >> 16) * fraction + (low >> 16));
}

/// From `a` (at 0, exact) to `b` (at 1, exact); rounded once. |a - b| is less than 32768 px.
constexpr Fixed lerp(Fixed a, Fixed b, Fraction fraction)
{
    return a + Fixed::from_raw(multiply_q16((b - a).raw(), static_cast<std::int32_t>(fraction.raw)));
}

/// From `a` (at 0, exact) to `b` (at 1, exact) and beyond; rounded once. |a - b| is less than 32768 px for
/// progress of 0 … 1. Beyond that, a and b are within ±4095 px, as all coordinates of a canvas: then the
/// result is within ±16380 px, and any two results are less than 32768 px apart.
constexpr Fixed lerp(Fixed a, Fixed b, Progress progress)
{
    return a + Fixed::from_raw(multiply_q16((b - a).raw(), progress.raw));
}

/// p a + q b in Q16, rounded to nearest, halves up. A factor 0 saves its product.
constexpr std::int64_t sum_of_products(std::int32_t p, std::int64_t a, std::int32_t q, std::int64_t b)
{
    std::int64_t sum = Fixed::one / 2;
    if (p != 0)
        sum += p * a;
    if (q != 0)
        sum += q * b;
    return sum >> 16;
}

/// Whether |value| is at most 1 << bits; `bits` is 0 … 30.
constexpr bool fits_in(std::int32_t value, int bits)
{
    expects(bits >= 0 && bits <= 30);
    return static_cast<std::uint32_t>(value) + (1U << bits) <= 2U << bits;
}

/// For factors in Q16, at most 8, and distances, at most 1024 px: sums of two products are within ±16384 px.
constexpr bool is_small_factor(std::int32_t factor) { return fits_in(factor, 19); }
constexpr bool is_small_distance(std::int32_t raw) { return fits_in(raw, 26); }

/// a b / 2^30, rounded down; both are within ±2^30.
constexpr std::int32_t product_q30_down(std::int32_t a, std::int32_t b)
{
    constexpr std::int32_t low_half = 0xFFFF;
    const std::int32_t a_high = a >> 16;
    const std::int32_t b_high = b >> 16;
    const auto low =
        (static_cast<std::uint32_t>(a & low_half) * static_cast<std::uint32_t>(b & low_half)) >> 16;
    const std::int32_t middle =
        a_high * (b & low_half) + (a & low_half) * b_high + static_cast<std::int32_t>(low);
    return a_high * b_high * 4 + (middle >> 14);
}

/// Like sum_of_products(), where that fits in 32 bits.
constexpr std::int32_t short_sum_of_products(std::int32_t p, std::int32_t a, std::int32_t q, std::int32_t b)
{
    constexpr std::uint32_t low_half = 0xFFFF;
    const auto low = [](std::int32_t value) { return static_cast<std::uint32_t>(value) & low_half; };
    const auto high = [](std::int32_t value) { return static_cast<std::uint32_t>(value >> 16); };
    const std::uint64_t rest = std::uint64_t{low(p) * low(a)} + low(q) * low(b) + Fixed::one / 2;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(p) * high(a) + high(p) * low(a) +
                                     static_cast<std::uint32_t>(q) * high(b) + high(q) * low(b) +
                                     static_cast<std::uint32_t>(rest >> 16));
}

/// The same, mostly in 32 bits.
[[gnu::noinline]] constexpr std::int64_t sum_of_products(std::int32_t p, std::int32_t a, std::int32_t q,
                                                         std::int32_t b)
{
    if (is_small_factor(p) && is_small_factor(q) && is_small_distance(a) && is_small_distance(b))
        return short_sum_of_products(p, a, q, b);
    return sum_of_products(p, std::int64_t{a}, q, std::int64_t{b});
}

/// The largest integer whose square is not larger than `value`.
template <std::unsigned_integral T>
constexpr std::uint32_t square_root(T value)
{
    T root = 0;
    for (T bit = T{1} << (std::numeric_limits<T>::digits / 2 - 1); bit != 0; bit >>= 1) {
        const T candidate = root | bit;
        if (candidate * candidate <= value)
            root = candidate;
    }
    return static_cast<std::uint32_t>(root);
}

/// `total` things distributed to `count` receivers as evenly as the original KFAST did it: each gets
/// total div count, and the first total mod count of them one more. `count` is at least 1.
struct Distribution {
    std::uint32_t each = 0;
    std::uint32_t extra = 0;

    constexpr Distribution() = default;
    constexpr Distribution(std::uint32_t total, std::uint32_t count) : each{1}
    {
        expects(count >= 1);
        if (total == count) // mostly, and small processors call a function to divide
            return;
        each = total / count;
        extra = total % count;
    }

    /// What receiver `index` (from 0) gets.
    constexpr std::uint32_t at(std::uint32_t index) const { return each + (index < extra ? 1 : 0); }
};

}
