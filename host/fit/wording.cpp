#include "host/fit/wording.hpp"

#include "host/counted.hpp"
#include "host/in_frames.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

namespace kfast::fit {
namespace {

std::string digits(double number, int precision)
{
    std::ostringstream text;
    text.precision(precision);
    text << number;
    return text.str();
}

struct Part {
    std::string_view name;
    std::size_t bytes;
};

template <std::size_t count>
std::string list_of(const std::array<Part, count>& parts)
{
    std::string list;
    for (const auto& [name, bytes] : parts)
        if (bytes != 0)
            list.append(list.empty() ? "" : ", ").append(name).append(" ").append(std::to_string(bytes));
    return list;
}

}

std::string bytes_text(std::size_t bytes) { return counted(bytes, "byte"); }

std::string frame_text(Time moment) { return digits(in_frames(moment), 12); }

std::string milliseconds_text(double seconds) { return digits(seconds * 1000, 3) + " ms"; }

std::string rate_text(double per_second)
{
    if (!std::isfinite(per_second))
        return "any rate";
    return digits(std::floor(per_second * 10) / 10, 12) + " fps";
}

std::string frequency_text(double hertz)
{
    return hertz >= 1e6 ? digits(hertz / 1e6, 6) + " MHz" : digits(hertz / 1e3, 6) + " kHz";
}

std::string parts_text(const FlashNeed& need)
{
    return list_of(
        std::array<Part, 3>{{{"player", need.player}, {"scene", need.scene}, {"reserved", need.reserved}}});
}

std::string parts_text(const RamNeed& need, std::string_view buffers)
{
    return list_of(std::array<Part, 5>{{{"block", need.block},
                                        {buffers, need.bands},
                                        {"static", need.fixed},
                                        {"stack", need.stack},
                                        {"reserved", need.reserved}}});
}

}
