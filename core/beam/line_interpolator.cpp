#include "core/beam/line_interpolator.hpp"

#include "core/pixel/paint_style.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace kfast {

namespace {

constexpr std::uint32_t longest_step = 1U << 31;

/// 2^(quarter / 4), in 1/256.
constexpr std::array<std::uint32_t, 4> quarter_octaves{256, 304, 362, 431};

std::uint32_t shown_brightness(Colour colour) { return std::max(brightness(colour), StepProfile::darkest); }

}

std::uint32_t StepProfile::scaled_step(std::uint32_t step) const
{
    const auto octaves = static_cast<unsigned>(speed_level_) >> 2;
    const std::uint32_t within = step * quarter_octaves[static_cast<unsigned>(speed_level_) & 3U] >> 8;
    return within >= longest_step >> octaves ? longest_step : within << octaves;
}

std::uint32_t StepProfile::lit_step(Colour colour) const
{
    std::uint32_t step = profile_->lit_step;
    if (profile_->brightness == BeamBrightness::by_speed)
        step = step * 255 / shown_brightness(colour);
    return scaled_step(step);
}

std::uint32_t StepProfile::travel_step() const
{
    return profile_->travel_step == 0 ? 0 : scaled_step(profile_->travel_step);
}

std::uint32_t StepProfile::dot_dwell(Colour colour) const
{
    std::uint32_t points = dot_points + 2U * profile_->lit_dwell;
    if (profile_->brightness == BeamBrightness::by_speed)
        points = points * shown_brightness(colour) / 255;
    return std::max<std::uint32_t>(dwell(points), 1);
}

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

namespace {

/// In x and y. A reversal from (32767, 32767) would take 59,000 more than 32 bits hold, as lengths
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
