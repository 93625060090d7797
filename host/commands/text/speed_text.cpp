#include "host/commands/text/speed_text.hpp"

#include "core/playhead.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

namespace kfast {
namespace {

constexpr double slowest_speed = 0.01;
constexpr double fastest_speed = Playhead::fastest / Playhead::as_authored;

}

std::int32_t read_speed(const std::string& option, const std::string& text)
{
    double factor = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, factor, std::chars_format::fixed);
    const bool in_range =
        std::abs(factor) >= slowest_speed && std::abs(factor) <= fastest_speed; // not if it is no number
    if (error != std::errc{} || rest != end || !in_range)
        throw CLI::ValidationError(option, "'" + text +
                                               "' is no speed: write a factor of 0.01 to 16, like 0.5, or "
                                               "-1 for backwards");
    return static_cast<std::int32_t>(std::lround(factor * Playhead::as_authored));
}

}
