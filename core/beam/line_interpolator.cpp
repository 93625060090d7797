#include "core/beam/line_interpolator.hpp"

#include <cstdlib>

namespace kfast {
namespace {

constexpr int slope_bits = 14;
constexpr std::uint32_t half = 1U << (slope_bits - 1);
constexpr std::uint32_t long_piece = 1U << (slope_bits - 2); ///< beyond it, 1/2^14 would be too coarse

}

void LineInterpolator::begin(FieldPoint from, FieldVector delta, std::uint32_t length)
{
    from_ = from;
    x_.begin(delta.x, length);
    y_.begin(delta.y, length);
}

FieldPoint LineInterpolator::at(std::uint32_t distance) const
{
    return {static_cast<std::int16_t>(from_.x + x_(distance)),
            static_cast<std::int16_t>(from_.y + y_(distance))};
}

void LineInterpolator::Slope::begin(std::int32_t rise, std::uint32_t length)
{
    falls = rise < 0;
    const std::uint32_t scaled = static_cast<std::uint32_t>(std::abs(rise)) << slope_bits;
    coarse = scaled / length;
    fine = length > long_piece ? ((scaled - coarse * length) << slope_bits) / length : 0;
}

/// A length is less than 2^17, so that all products fit in 32 bits.
std::int32_t LineInterpolator::Slope::operator()(std::uint32_t distance) const
{
    const std::uint32_t rise = coarse * distance + (fine * distance >> slope_bits);
    const auto units = static_cast<std::int32_t>((rise + half) >> slope_bits);
    return falls ? -units : units;
}

}
