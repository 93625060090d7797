#pragma once

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace kfast {

/// "1 frame", "2 frames"
inline std::string counted(std::size_t number, const std::string& noun)
{
    return std::to_string(number) + ' ' + noun + (number == 1 ? "" : "s");
}

/// How many keys a list in a line has at most, for readers; programs read JSON, which has all.
inline constexpr std::size_t most_listed = 100;

/// The end of a list of `number` of which the first are written: " ... and 12 more"; empty: they are all
/// written.
inline std::string rest_of_list(std::size_t number)
{
    return number > most_listed ? " ... and " + std::to_string(number - most_listed) + " more" : "";
}

/// With at most four digits after the point: what is stored, or visible, is no finer.
inline std::string rounded_text(double number)
{
    std::ostringstream text;
    text.precision(12);
    text << std::round(number * 10'000) / 10'000 + 0.0; // no negative zero
    return text.str();
}

}
