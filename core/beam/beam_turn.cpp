#include "core/beam/beam_turn.hpp"

#include <cstdlib>

namespace kfast {
namespace {

/// In x and y. A turn right round from (32767, 32767) would take 59,000 more than 32 bits hold, as lengths
/// are a little too long.
constexpr std::int32_t longest_exact = field_max - 1;

}

BeamDirection::BeamDirection(FieldVector piece, std::uint32_t length)
{
    if (length < shortest)
        return;
    const bool is_long = std::abs(piece.x) > longest_exact || std::abs(piece.y) > longest_exact;
    x_ = is_long ? piece.x / 4 : piece.x;
    y_ = is_long ? piece.y / 4 : piece.y;
    length_ = is_long ? length / 4 : length;
}

BeamTurn::BeamTurn(const BeamDirection& before, const BeamDirection& after)
{
    if (!before.is_known() || !after.is_known())
        return;
    whole_ = before.length_ * after.length_;
    const std::int32_t along = before.x_ * after.x_ + before.y_ * after.y_;
    const bool is_straight = along > 0 && static_cast<std::uint32_t>(along) >= whole_;
    rest_ = is_straight ? 0 : whole_ - static_cast<std::uint32_t>(along);
}

std::uint32_t BeamTurn::share_of(std::uint32_t max) const
{
    if (!is_corner())
        return 0;
    const int spare = whole_ >= 1U << 22 ? 10 : 0; // so that most * rest fits
    const std::uint32_t whole = whole_ >> spare;
    return (max * (rest_ >> spare) + whole) / (2 * whole);
}

}
