#include "core/beam/beam_piece.hpp"

#include <cstdlib>

namespace kfast {
namespace {

constexpr int slope_bits = 14;
constexpr std::uint32_t half = 1U << (slope_bits - 1);
constexpr std::uint32_t long_piece = 1U << (slope_bits - 2); ///< beyond it, 1/2^14 would be too coarse

}

BeamPiece::BeamPiece(FieldPoint from, FieldPoint to) : from_{from}
{
    const FieldVector way = to - from;
    length_ = way.length();
    if (length_ == 0)
        return;
    x_ = {way.x, length_};
    y_ = {way.y, length_};
}

FieldPoint BeamPiece::at(std::uint32_t distance) const
{
    return {static_cast<std::int16_t>(from_.x + x_(distance)),
            static_cast<std::int16_t>(from_.y + y_(distance))};
}

BeamPiece::Slope::Slope(std::int32_t rise, std::uint32_t length) : falls{rise < 0}
{
    const std::uint32_t scaled = static_cast<std::uint32_t>(std::abs(rise)) << slope_bits;
    coarse = scaled / length;
    if (length > long_piece)
        fine = ((scaled - coarse * length) << slope_bits) / length;
}

/// A length is less than 2^17, so that all products fit in 32 bits.
std::int32_t BeamPiece::Slope::operator()(std::uint32_t distance) const
{
    const std::uint32_t rise = coarse * distance + (fine * distance >> slope_bits);
    const auto units = static_cast<std::int32_t>((rise + half) >> slope_bits);
    return falls ? -units : units;
}

}
