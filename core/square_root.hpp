#pragma once

#include <cstdint>

namespace kfast {

/// The largest integer whose square is not larger than `value`.
constexpr std::uint32_t square_root(std::uint32_t value)
{
    std::uint32_t root = 0;
    for (std::uint32_t bit = 1U << 15; bit != 0; bit >>= 1) {
        const std::uint32_t candidate = root | bit;
        if (candidate * candidate <= value)
            root = candidate;
    }
    return root;
}

}
