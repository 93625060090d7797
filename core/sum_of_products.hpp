#pragma once

#include "core/fixed.hpp"

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

}
