#pragma once

#include <cmath>
#include <sstream>
#include <string>

namespace kfast {

/// With at most four digits behind the point: what is stored is coarser, or seen no finer.
inline std::string rounded_text(double number)
{
    std::ostringstream text;
    text.precision(12);
    text << std::round(number * 10'000) / 10'000 + 0.0; // no negative zero
    return text.str();
}

}
