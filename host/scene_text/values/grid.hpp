#pragma once

#include "core/math/angle.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/property.hpp"
#include "core/time/clock.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"
#include "host/kdl/document.hpp"

#include <cstdint>
#include <string>

namespace kfast::scene_text {

/// How a number of the scene language is stored: `stored` for every `units` of what is written.
struct Grid {
    double stored = 1;
    double units = 1;
    double low = 0; ///< what may be written
    double high = 0;
};

inline constexpr Grid coordinates{16, 1, -2047, 2047};
inline constexpr Grid times{Time::ticks_per_frame, 1, 0, 1'000'000};
inline constexpr Grid signed_times{Time::ticks_per_frame, 1, -1'000'000, 1'000'000};
inline constexpr Grid speeds{Clock::normal_speed, 1, -16, 16};
inline constexpr Grid degrees{BinaryAngle::turn, 360, -5760, 5760};
inline constexpr Grid scales{kfb::max_scale, 64, -64, 64};
inline constexpr Grid shares{path_whole, 1, 0, 1};
inline constexpr Grid offsets{path_whole, 1, -16, 16};
inline constexpr Grid opacities{255, 1, 0, 1};
inline constexpr Grid widths{16, 1, 0, 4095};
inline constexpr Grid still_widths{16, 1, 1.0 / 16, 4095};
inline constexpr Grid dash_lengths{dash_pixel, 1, 0, max_dash_pixels};
inline constexpr Grid dash_offsets{dash_pixel, 1, -max_dash_pixels, max_dash_pixels};
inline constexpr Grid miters{8, 1, 1, 31};
inline constexpr Grid controls{VelocityLaw::control_one, 1, -2, 3};
inline constexpr Grid frame_rates{1000, 1, 1, 1000};
inline constexpr Grid turns{BinaryAngle::turn, 360, -5400, 5400};

/// The nearest that is stored, halves away from zero; what is out of range is clamped. `value` is
/// finite.
std::int32_t on_grid(double value, const Grid& grid);
/// The value that is stored as `stored`.
double off_grid(std::int32_t stored, const Grid& grid);
/// The nearest that can be stored, as on_grid().
double snapped(double value, const Grid& grid);

/// The decimal with the fewest digits that is stored as `stored`.
std::string decimal(std::int32_t stored, const Grid& grid);

kdl::Value number(std::int32_t stored, const Grid& grid);
kdl::Value number(std::size_t whole);
/// A number that is not stored as it is, to nine decimals.
kdl::Value exact(double value);

}
