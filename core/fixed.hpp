#pragma once

#include <compare>
#include <cstdint>

namespace kfast {

/// A share of a whole, 0 … 1, in Q16: 65536 is the whole.
struct Share {
    std::uint32_t raw = 0;

    static constexpr std::uint32_t one = 65536;

    /// numerator / denominator for 0 <= numerator <= denominator, rounded to nearest, halves up.
    /// `denominator` is at least 1 and less than 2^31.
    static constexpr Share ratio(std::uint32_t numerator, std::uint32_t denominator)
    {
        if (numerator < 0x4000) // keeps the division in 32 bits
            return {((numerator << 16) + denominator / 2) / denominator};
        const std::uint64_t scaled = (std::uint64_t{numerator} << 16) + denominator / 2;
        return {static_cast<std::uint32_t>(scaled / denominator)};
    }

    friend constexpr auto operator<=>(Share, Share) = default;
};

/// A length in pixels in Q16.16: 1/65536 px, -32768 … 32767 px. Sums and differences do not check their
/// range.
class Fixed {
public:
    constexpr Fixed() = default;
    static constexpr Fixed from_raw(std::int32_t raw) { return Fixed{raw}; }
    static constexpr Fixed pixels(std::int32_t count) { return Fixed{count * one}; }
    /// The unit in which scenes store coordinates.
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

/// value * factor / 2^bits, rounded to nearest, halves up.
constexpr std::int32_t multiply(std::int32_t value, std::int32_t factor, int bits)
{
    const std::int64_t half = std::int64_t{1} << (bits - 1);
    return static_cast<std::int32_t>((std::int64_t{value} * factor + half) >> bits);
}

/// From `a` (share 0, exact) to `b` (share 1, exact); rounded once. |a - b| is less than 32768 px.
constexpr Fixed lerp(Fixed a, Fixed b, Share share)
{
    return a + Fixed::from_raw(multiply((b - a).raw(), static_cast<std::int32_t>(share.raw), 16));
}

}
