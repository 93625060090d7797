#pragma once

#include <concepts>
#include <cstdint>
#include <limits>

namespace kfast {

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

}
