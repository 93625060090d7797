#pragma once

#include <cstdint>

namespace kfast {

/// A place in the field, the square that the beam of a vector display can reach: 65536 units wide and high,
/// x to the right, y up, (0, 0) in the middle, as in ILDA's files. A DAC of n bits has 2^(16 - n) units a
/// step. Aligned so that small processors copy it as a word, not by a call.
struct alignas(4) FieldPoint {
    std::int16_t x = 0;
    std::int16_t y = 0;

    friend constexpr bool operator==(FieldPoint, FieldPoint) = default;
};

inline constexpr std::int32_t field_side = 65536;
inline constexpr std::int32_t field_least = -32768;
inline constexpr std::int32_t field_most = 32767;

}
