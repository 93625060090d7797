#pragma once

#include "core/math/quotient.hpp"

#include <compare>
#include <cstdint>

namespace kfast {

/// A share of a whole, 0 … 1, in Q16: 65536 is the whole.
struct Share {
    std::uint32_t raw = 0;

    static constexpr std::uint32_t one = 65536;

    /// numerator / denominator for 0 <= numerator <= denominator, rounded to nearest, halves up.
    /// `denominator` is at least 1.
    static constexpr Share ratio(std::uint32_t numerator, std::uint32_t denominator)
    {
        if (numerator < 0x4000) // keeps the division in 32 bits
            return {((numerator << 16) + denominator / 2) / denominator};
        const std::uint64_t scaled = (std::uint64_t{numerator} << 16) + denominator / 2;
        return {static_cast<std::uint32_t>(quotient(scaled, denominator))};
    }

    friend constexpr auto operator<=>(Share, Share) = default;
};

/// A share of the way between two keys in Q16: 65536 is the whole. Velocity laws may swing beyond both ends,
/// within -1.5 … 2.5.
struct Way {
    std::int32_t raw = 0;

    static constexpr std::int32_t one = 65536;

    friend constexpr auto operator<=>(Way, Way) = default;
};

/// A length in pixels in Q16.16: 1/65536 px, -32768 … 32767 px. Sums and differences do not check their
/// range.
class Fixed {
public:
    constexpr Fixed() = default;
    static constexpr Fixed from_raw(std::int32_t raw) { return Fixed{raw}; }
    /// `count` is within -32768 … 32767.
    static constexpr Fixed pixels(std::int32_t count) { return Fixed{count * one}; }
    /// The unit in which scenes store coordinates; `count` is within -524288 … 524287.
    static constexpr Fixed sixteenths(std::int32_t count) { return Fixed{count * (one / 16)}; }

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

/// value * factor / 2^bits, rounded to nearest, halves up. `bits` is 1 … 62 and the result fits.
constexpr std::int32_t multiply(std::int32_t value, std::int32_t factor, int bits)
{
    const std::int64_t half = std::int64_t{1} << (bits - 1);
    return static_cast<std::int32_t>((std::int64_t{value} * factor + half) >> bits);
}

/// As multiply() with 16 bits. Small processors multiply 32 bits in a cycle, and 64 bits by a function.
constexpr std::int32_t multiply_q16(std::int32_t value, std::int32_t factor)
{
    constexpr std::uint32_t low_half = 0xFFFF;
    const auto fraction = static_cast<std::uint32_t>(factor) & low_half;
    const std::uint32_t low = (static_cast<std::uint32_t>(value) & low_half) * fraction + low_half / 2 + 1;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) *
                                         static_cast<std::uint32_t>(factor >> 16) +
                                     static_cast<std::uint32_t>(value >> 16) * fraction + (low >> 16));
}

/// From `a` (share 0, exact) to `b` (share 1, exact); rounded once. |a - b| is less than 32768 px.
constexpr Fixed lerp(Fixed a, Fixed b, Share share)
{
    return a + Fixed::from_raw(multiply_q16((b - a).raw(), static_cast<std::int32_t>(share.raw)));
}

/// From `a` (way 0, exact) to `b` (way 1, exact) and beyond; rounded once. |a - b| is less than 32768 px
/// for ways of 0 … 1. For ways beyond, a and b are within ±4095 px, as all coordinates of a canvas: then the
/// result is within ±16380 px, and any two results are less than 32768 px apart.
constexpr Fixed lerp(Fixed a, Fixed b, Way way)
{
    return a + Fixed::from_raw(multiply_q16((b - a).raw(), way.raw));
}

}
