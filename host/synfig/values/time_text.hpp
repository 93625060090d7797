#pragma once

#include <optional>
#include <string_view>

namespace kfast::synfig {

// Seconds. Finite, so that ways from and to them can be computed.
inline constexpr double begin_of_time = -1e7;
inline constexpr double end_of_time = 1e7;

/// Seconds of a time as files have it: "1s 12f", "2m", "36f", "SOT", "EOT"; a number without a unit counts
/// frames. Nothing if it is none of these.
std::optional<double> time_of(std::string_view text, double frame_rate);

}
