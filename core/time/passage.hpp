#pragma once

#include "core/math/fixed.hpp"
#include "core/time/hermite.hpp"

#include <cstdint>

namespace kfast {

/// Two values of keys, and how far the way from one to the other has come.
struct Passage {
    std::int32_t from;
    std::int32_t to;
    Way way;
};

/// Which of the two laws of a key governs.
enum class LawAxis : std::uint8_t { x, y };

/// Of a quantity in 1/16 px, in 1/256 of it.
constexpr Fixed fine_pixels(std::int32_t fine)
{
    return Fixed::from_raw(fine * (Fixed::one >> (4 + fine_bits)));
}

/// Rounded to nearest, halves up, in 1/256 of the unit of the values.
constexpr std::int32_t fine_value(const Passage& passage)
{
    return passage.from * (1 << fine_bits) +
           multiply(passage.to - passage.from, passage.way.raw, 16 - fine_bits);
}

}
