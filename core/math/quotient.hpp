#pragma once

#include <bit>
#include <cstdint>

namespace kfast {

/// (high * 2^32 + low) / divisor, rounded down, for high < divisor: then it has 32 bits.
///
/// By two digits of 16 bits, each guessed from the highest 16 bits of the divisor and at most two too large
/// (Knuth, The Art of Computer Programming, volume 2, 4.3.1, algorithm D). What compilers call for 64-bit
/// divisions takes ten times the code on processors of 32 bits.
constexpr std::uint32_t long_quotient(std::uint32_t high, std::uint32_t low, std::uint32_t divisor)
{
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

}
