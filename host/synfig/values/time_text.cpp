#include "host/synfig/values/time_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace kfast::synfig {
namespace {

std::string lower_without_blanks(std::string_view text)
{
    std::string result;
    for (const char letter : text)
        if (!std::isspace(static_cast<unsigned char>(letter)))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return result;
}

std::optional<double> seconds_of(char unit, double frame_rate)
{
    switch (unit) {
    case 'h':
        return 3600;
    case 'm':
        return 60;
    case 's':
        return 1;
    case 'f':
        return 1 / frame_rate;
    default:
        return {};
    }
}

}

std::optional<double> time_of(std::string_view text, double frame_rate)
{
    const std::string compact = lower_without_blanks(text);
    if (compact == "sot" || compact == "bot")
        return begin_of_time;
    if (compact == "eot")
        return end_of_time;
    double total = 0;
    const char* at = compact.data();
    const char* const end = at + compact.size();
    while (at != end) {
        double amount = 0;
        const auto read = std::from_chars(at, end, amount);
        if (read.ec != std::errc{} || !std::isfinite(amount))
            return {};
        const auto unit = seconds_of(read.ptr == end ? 'f' : *read.ptr, frame_rate);
        if (!unit)
            return {};
        total += amount * *unit;
        at = read.ptr == end ? end : read.ptr + 1;
    }
    return std::isfinite(total) && !compact.empty() ? std::optional{total} : std::nullopt;
}

}
