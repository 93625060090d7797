#pragma once

#include "core/math/fixed.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// a * b in Q30, rounded to nearest but for 1/1000 of a unit. Small processors call a function to multiply
/// 64 bits.
constexpr std::int32_t product_q30(std::int32_t a, std::int32_t b)
{
    const auto low = [](std::int32_t value) { return static_cast<std::uint32_t>(value) & 0xFFFF; };
    const auto half = [low](std::int32_t high, std::int32_t other) { // of a product of 16 x 16 bits
        return (high >> 16) * static_cast<std::int32_t>(low(other)) >> 1;
    };
    const auto lowest = static_cast<std::int32_t>(low(a) * low(b) >> 17);
    return (a >> 16) * (b >> 16) * 4 + rounded_shift(half(a, b) + half(b, a) + lowest, 13);
}

/// Horner's scheme in Q30: coefficients from the lowest power, `at` in 0 … 1.
template <std::size_t count>
constexpr std::int32_t polynomial(const std::array<std::int32_t, count>& coefficients, std::int32_t at)
{
    std::int32_t sum = coefficients[count - 1];
    for (std::size_t i = count - 1; i-- > 0;)
        sum = coefficients[i] + product_q30(sum, at);
    return sum;
}

}
