#pragma once

#include "core/bytes/bit_reader.hpp"
#include "core/bytes/byte_reader.hpp"

#include <cstdint>

namespace kfast {

/// Numbers of which each key has one, in as many bits as they take (docs/format.md, "Values"); borrows the
/// scene's bytes.
class PackedValues {
public:
    PackedValues() = default;
    /// Takes `bytes` as far as `count` values go. Each is `more` than what is stored.
    static PackedValues take(ByteReader& bytes, std::uint32_t count, std::int32_t more = 0);

    /// Where take() has found them.
    const std::byte* place() const { return place_; }
    /// Nothing more than what is stored.
    PackedValues as_stored() const
    {
        PackedValues values = *this;
        values.more_ = 0;
        return values;
    }
    /// `index` is less than their number. Wraps around rather than overflow.
    std::int32_t operator[](std::uint32_t index) const;

private:
    const std::byte* place_ = nullptr;
    BitReader bits_;
    std::uint32_t min_ = 0;
    std::uint32_t more_ = 0;
    std::uint8_t width_ = 0;
    std::uint8_t unit_ = 0;
};

/// The unit of values that are whole degrees; the others are powers of two.
inline constexpr std::uint32_t degree_unit = 7;

/// A stored number in its unit, 0 … degree_unit. Degrees become 1/65536 turn, rounded to nearest; up to
/// 30,000 of them in each direction.
constexpr std::int32_t in_unit(std::uint32_t number, std::uint32_t unit)
{
    if (unit != degree_unit)
        return static_cast<std::int32_t>(number << unit);
    // 65536 / 360 is 182 and 2/45.
    const std::int32_t rest = static_cast<std::int32_t>(46603 * number + (1U << 19)) >> 20;
    return static_cast<std::int32_t>(182 * number + static_cast<std::uint32_t>(rest));
}

}
