#include "core/beam/step_profile.hpp"

#include "core/pixel/colour.hpp"

#include <algorithm>
#include <array>

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

}
