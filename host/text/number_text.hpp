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

/// With at most four digits after the point: what is stored, or visible, is no finer.
inline std::string rounded_text(double number)
{
    std::ostringstream text;
    text.precision(12);
    text << std::round(number * 10'000) / 10'000 + 0.0; // no negative zero
    return text.str();
}

}
