#include "host/fit/wording.hpp"

#include "host/text/number_text.hpp"
#include "host/words/scene_words.hpp"

#include <cmath>
#include <sstream>
#include <string_view>
#include <vector>

namespace kfast::fit {
namespace {

std::string digits(double number, int precision)
{
    std::ostringstream text;
    text.precision(precision);
    text << number;
    return text.str();
}

constexpr double fastest_rate = 1000;
constexpr double kibibyte = 1024;
constexpr double mebibyte = kibibyte * kibibyte;

struct Part {
    std::string_view name;
    std::size_t bytes;
};

std::string exact_text(std::size_t bytes) { return std::to_string(bytes); }

/// Lists the parts that are not zero.
std::string list_of(const std::vector<Part>& parts, std::string (*text)(std::size_t))
{
    std::string list;
    for (const auto& [name, bytes] : parts)
        if (bytes != 0)
            list.append(list.empty() ? "" : ", ").append(name).append(" ").append(text(bytes));
    return list;
}

/// Three digits: "4.79", "61.2", "256"
std::string rounded(double number)
{
    return number < 999.5 ? digits(number, 3) : digits(std::round(number), 12);
}

std::string firmware_text(std::size_t bytes, std::size_t available, std::string_view memory,
                          const std::vector<Part>& parts)
{
    return memory_text(bytes) + " of " + memory_text(available) + " of " + std::string{memory} + ": " +
           list_of(parts, memory_text);
}

void add_reserved(const Target& target, std::size_t Reserved::*bytes, std::vector<Part>& parts)
{
    for (const Reserved& part : target.reserved)
        parts.push_back({part.name.empty() ? std::string_view{"reserved"} : part.name, part.*bytes});
}

}

std::string bytes_text(std::size_t bytes) { return counted(bytes, "byte"); }

std::string memory_text(std::size_t bytes)
{
    const auto number = static_cast<double>(bytes);
    if (number < kibibyte)
        return std::to_string(bytes) + " B";
    return number < mebibyte ? rounded(number / kibibyte) + " KiB" : rounded(number / mebibyte) + " MiB";
}

std::string frame_text(Time moment) { return digits(in_frames(moment), 12); }

std::string milliseconds_text(double seconds) { return digits(seconds * 1000, 3) + " ms"; }

std::string watchdog_reason(double seconds, Time moment, const Target& target)
{
    if (target.watchdog == 0 || seconds <= target.watchdog)
        return {};
    return "watchdog: frame " + frame_text(moment) + " takes " + digits(seconds, 3) +
           " s to compute, but after " + digits(target.watchdog, 3) +
           " s the board's watchdog restarts it: show less at once, or draw with fewer points";
}

std::string rate_text(double per_second)
{
    if (per_second > fastest_rate)
        return "more than " + digits(fastest_rate, 12) + " fps";
    return digits(std::floor(per_second * 10) / 10, 12) + " fps";
}

std::string frequency_text(double hertz)
{
    return hertz >= 1e6 ? digits(hertz / 1e6, 6) + " MHz" : digits(hertz / 1e3, 6) + " kHz";
}

std::string parts_text(const FlashNeed& need)
{
    return list_of({{"player", need.player}, {"scene", need.scene}, {"reserved", need.reserved}}, exact_text);
}

std::string parts_text(const RamNeed& need, std::string_view buffers)
{
    return list_of({{"block", need.block},
                    {buffers, need.bands},
                    {"static", need.fixed},
                    {"stack", need.stack},
                    {"reserved", need.reserved}},
                   exact_text);
}

std::string firmware_flash_text(const FlashNeed& need, const Target& target)
{
    const std::string player = need.features ? "player with " + features_text(*need.features) : "player";
    std::vector<Part> parts{{player, need.player}};
    add_reserved(target, &Reserved::flash, parts);
    return firmware_text(need.sum() - need.scene, target.flash, "flash", parts);
}

std::string firmware_ram_text(const RamNeed& need, const Target& target, std::string_view buffers)
{
    std::vector<Part> parts{{buffers, need.bands}, {"static", need.fixed}, {"stack", need.stack}};
    add_reserved(target, &Reserved::ram, parts);
    return firmware_text(need.sum() - need.block, target.ram, "RAM", parts);
}

}
