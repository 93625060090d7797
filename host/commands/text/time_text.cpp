#include "host/commands/text/time_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace kfast {
namespace {

/// Frames that one of `unit` is; 0 for an unknown unit.
double frames_in(std::string_view unit, double frame_rate)
{
    if (unit.empty())
        return 1;
    if (unit == "s")
        return frame_rate / 1000;
    return unit == "ms" ? frame_rate / 1'000'000 : 0;
}

}

std::optional<Time> read_time(std::string_view text, std::uint32_t frame_rate)
{
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [unit, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const double frames = frames_in({unit, static_cast<std::size_t>(end - unit)}, frame_rate);
    const double ticks = std::round(number * frames * Time::ticks_per_frame);
    const bool fits = ticks >= 0 && ticks <= std::numeric_limits<std::int32_t>::max();
    if (error != std::errc{} || frames == 0 || !fits)
        return std::nullopt;
    return Time{static_cast<std::int32_t>(ticks)};
}

}
