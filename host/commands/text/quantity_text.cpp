#include "host/commands/text/quantity_text.hpp"

#include "core/player.hpp"
#include "core/playhead.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/characters.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

namespace kfast {

namespace {

/// A side of a panel, and what follows it; 0 for anything else.
int read_side(std::string_view& text)
{
    int side = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    return error == std::errc{} && side >= 1 && side <= Player::max_panel ? side : 0;
}

}

Size read_size(const std::string& option, const std::string& text)
{
    std::string_view rest = text;
    Size size{read_side(rest), 0};
    if (rest.starts_with('x')) {
        rest.remove_prefix(1);
        size.height = read_side(rest);
    }
    if (size.width == 0 || size.height == 0 || !rest.empty())
        throw CLI::ValidationError(option, "'" + text +
                                               "' is no size: write it like 240x135, with sides of 1 to " +
                                               std::to_string(Player::max_panel));
    return size;
}

std::string size_text(Size size) { return std::to_string(size.width) + 'x' + std::to_string(size.height); }

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

namespace {

constexpr double fastest_clock = 1e9;

}

std::uint32_t read_clock(const std::string& option, const std::string& text)
{
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const auto unit =
        std::ranges::find(schema::frequency_units, std::string_view{rest, end}, &schema::QuantityUnit::name);
    const double hz = unit == schema::frequency_units.end() ? 0 : number * unit->factor;
    if (error != std::errc{} || !(hz >= 1 && hz <= fastest_clock))
        throw CLI::ValidationError(option, "'" + visible(text) +
                                               "' is no clock: write it like 40MHz, 400kHz or 9600Hz");
    return static_cast<std::uint32_t>(std::lround(hz));
}

std::string clock_text(std::uint32_t hz)
{
    const auto unit = std::ranges::find_if(schema::frequency_units.rbegin(), schema::frequency_units.rend(),
                                           [hz](const auto& row) { return hz >= row.factor; });
    std::ostringstream text;
    text << hz / unit->factor << ' ' << unit->name;
    return text.str();
}

std::uint8_t read_brightness(const std::string& option, const std::string& text)
{
    constexpr double brightest = 255;
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const bool is_share = std::string_view{rest, end} == "%";
    const double max = is_share ? 100 : brightest;
    if (error != std::errc{} || !(is_share || rest == end) || !(number >= 0 && number <= max))
        throw CLI::ValidationError(option, "'" + visible(text) +
                                               "' is no brightness: write 0 to 255, or a share like 40%");
    return static_cast<std::uint8_t>(std::lround(number * brightest / max));
}

}
