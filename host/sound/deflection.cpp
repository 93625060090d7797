#include "host/sound/deflection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kfast {

namespace {

constexpr double units_of_sound = 65536; ///< in one of the field

std::int32_t level(std::int16_t place, bool is_inverted, double gain)
{
    using Limits = std::numeric_limits<std::int32_t>;
    const double level = std::round(place * (is_inverted ? -gain : gain) * units_of_sound);
    return static_cast<std::int32_t>(
        std::clamp(level, static_cast<double>(Limits::min()), static_cast<double>(Limits::max())));
}

}

StereoSample Deflection::sample(FieldPoint at) const
{
    const std::int32_t x = level(at.x, inverts_x, gain);
    const std::int32_t y = level(at.y, inverts_y, gain);
    return is_swapped ? StereoSample{y, x} : StereoSample{x, y};
}

}
