#pragma once

#include "core/math/fixed.hpp"

#include <cstdint>

namespace kfast {

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

/// Whether |value| is at most 1 << bits.
constexpr bool fits_in(std::int32_t value, int bits)
{
    return static_cast<std::uint32_t>(value) + (1U << bits) <= 2U << bits;
}

/// Of factors in Q16, at most 8, and of ways, at most 1024 px: sums of two products are within ±16384 px.
constexpr bool is_modest_factor(std::int32_t factor) { return fits_in(factor, 19); }
constexpr bool is_modest_way(std::int32_t raw) { return fits_in(raw, 26); }

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

/// As sum_of_products() where that fits in 32 bits.
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

/// p a + q b in Q16, likewise, mostly in 32 bits.
[[gnu::noinline]] constexpr std::int64_t sum_of_products(std::int32_t p, std::int32_t a, std::int32_t q,
                                                         std::int32_t b)
{
    if (is_modest_factor(p) && is_modest_factor(q) && is_modest_way(a) && is_modest_way(b))
        return short_sum_of_products(p, a, q, b);
    return sum_of_products(p, std::int64_t{a}, q, std::int64_t{b});
}

}
