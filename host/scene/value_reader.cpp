#include "host/scene/value_reader.hpp"

#include "host/kdl/identifier.hpp"
#include "host/kdl/number.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/synonyms.hpp"
#include "host/text/glyph.hpp"
#include "host/words/in_frames.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kfast::scene {
namespace {

/// A number of frames or of this many milliseconds.
struct Unit {
    std::string_view name;
    double milliseconds;
};

constexpr std::array units{Unit{"s", 1000}, Unit{"ms", 1}};

/// If a number is meant by what is a text; empty: it is none.
std::string remedy_of_text(const std::string& text)
{
    constexpr std::string_view minus = "\u2212";
    const bool is_typographic = text.starts_with(minus);
    const std::string plain = is_typographic ? '-' + text.substr(minus.size()) : text;
    if (!kdl::begins_like_number(plain) || !std::holds_alternative<kdl::Number>(kdl::number_from(plain)))
        return {};
    return "write " + plain + (is_typographic ? ", with the minus of the keyboard" : " without quotes");
}

/// A type annotation means something on times only.
const kdl::Number* number_of(const kdl::Value& value, Reading& reading)
{
    const kdl::Number* const number = value.number();
    const std::string* const text = value.string();
    if (number == nullptr)
        reading.report.error(value.place, "a number is expected here",
                             text == nullptr ? std::string{} : remedy_of_text(*text));
    return number;
}

bool without_type(const kdl::Value& value, Reading& reading)
{
    return !value.type || reading.report.error(value.place, "this value takes no type or unit",
                                               "leave out (" + visible(*value.type) + ")");
}

std::optional<double> ticks_per(const kdl::Value& value, Reading& reading)
{
    if (!value.type)
        return Time::ticks_per_frame;
    std::array<std::string_view, units.size()> known;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (units[i].name == *value.type)
            return units[i].milliseconds * reading.frame_rate * Time::ticks_per_frame / 1e6;
        known[i] = units[i].name;
    }
    reading.report.error(value.place, "unknown unit " + in_quotes(*value.type),
                         suggestion(*value.type, known) + " (frames have no unit)");
    return std::nullopt;
}

/// Of an unknown colour: "orangered", "linear-gradient(red, blue)", "rgb(1,2,3)".
std::string remedy_of(std::string_view colour, const Palette& palette)
{
    const std::string_view function = colour.substr(0, std::min(colour.find('('), colour.size()));
    if (std::string absent = remedy_of_absent(function); !absent.empty())
        return absent;
    if (function != colour)
        return "write \"#rrggbb\"";
    if (std::string close = did_you_mean(colour, palette.names()); !close.empty())
        return close;
    return suggestion("", palette.common_names()) + ", another colour of CSS, or \"#rrggbb\"";
}

bool is_control(char letter)
{
    const auto code = static_cast<unsigned char>(letter);
    return code < 0x20 || code == 0x7F;
}

}

std::string text_of(double number)
{
    std::array<char, 32> digits;
    return {
        digits.data(),
        std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed).ptr};
}

std::string allowed(Range range) { return "allowed: " + text_of(range.low) + " to " + text_of(range.high); }

std::int32_t thousandths(double number) { return static_cast<std::int32_t>(std::lround(number * 1000)); }

std::optional<double> read_number(const kdl::Value& value, Range range, Reading& reading)
{
    const kdl::Number* const number = number_of(value, reading);
    if (number == nullptr || !without_type(value, reading))
        return std::nullopt;
    if (number->value >= range.low && number->value <= range.high)
        return number->value;
    report_out_of_range(value, range, reading);
    return std::nullopt;
}

void report_out_of_range(const kdl::Value& value, Range range, Reading& reading)
{
    reading.report.error(value.place, "this number is out of range", allowed(range));
}

std::optional<std::vector<double>> read_numbers(std::span<const kdl::Value> values,
                                                std::span<const Range> ranges, Reading& reading)
{
    std::vector<double> numbers;
    for (const kdl::Value& value : values) {
        const std::size_t place = std::min(numbers.size(), ranges.size() - 1);
        const auto number = read_number(value, ranges[place], reading);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<int> read_whole_number(const kdl::Value& value, Range range, Reading& reading)
{
    const auto number = read_number(value, range, reading);
    if (!number)
        return std::nullopt;
    if (std::trunc(*number) == *number)
        return static_cast<int>(*number);
    reading.report.error(value.place, "a whole number is expected here");
    return std::nullopt;
}

std::optional<bool> read_flag(const kdl::Value& value, Reading& reading)
{
    const bool* const flag = std::get_if<bool>(&value.data);
    if (flag == nullptr)
        reading.report.error(value.place, "#true or #false is expected here");
    if (flag == nullptr || !without_type(value, reading))
        return std::nullopt;
    return *flag;
}

std::optional<std::string_view> read_text(const kdl::Value& value, Reading& reading)
{
    const std::string* const text = value.string();
    if (text == nullptr)
        reading.report.error(value.place, "a word or a text in quotes is expected here");
    if (text == nullptr || !without_type(value, reading))
        return std::nullopt;
    return *text;
}

std::optional<std::string_view> read_name(const kdl::Value& value, Reading& reading)
{
    const auto name = read_text(value, reading);
    if (!name)
        return std::nullopt;
    if (name->empty())
        reading.report.error(value.place, "a name cannot be empty");
    else if (name->size() > longest_name)
        reading.report.error(value.place, "this name is too long",
                             "a name has at most " + std::to_string(longest_name) + " bytes");
    else if (std::ranges::any_of(*name, is_control)) // boards write names into lines of text
        reading.report.error(value.place, "a name has no line ends or other control characters");
    else
        return name;
    return std::nullopt;
}

std::optional<Time> read_time(const kdl::Value& value, Reading& reading)
{
    const kdl::Number* const number = number_of(value, reading);
    const auto scale = number != nullptr ? ticks_per(value, reading) : std::nullopt;
    if (!scale)
        return std::nullopt;
    const double ticks = number->value * *scale;
    if (ticks >= 0 && ticks <= Time::frame(most_frames).ticks)
        return Time{static_cast<std::int32_t>(std::lround(ticks))};
    if (ticks < 0)
        reading.report.error(value.place, "a time cannot be negative");
    else
        reading.report.error(value.place, "this time is out of range",
                             "allowed: up to " + std::to_string(most_frames) + " frames");
    return std::nullopt;
}

std::string text_of(Time time) { return text_of(in_frames(time)); }

std::optional<std::size_t> read_colour(const kdl::Value& value, Reading& reading)
{
    if (value.string() == nullptr) {
        reading.report.error(value.place, "a colour is expected here", "write its name or \"#rrggbb\"");
        return std::nullopt;
    }
    const auto text = read_text(value, reading);
    if (!text)
        return std::nullopt;
    const auto colour = reading.palette.find(std::string{*text});
    if (!colour) {
        report_unknown_colour(value, *text, reading.palette, reading);
        return std::nullopt;
    }
    const auto index = reading.palette.use(*colour);
    if (!index)
        reading.report.error(value.place, "too many colours",
                             "a scene holds at most " + std::to_string(most_colours) +
                                 ", background included");
    return index;
}

void report_unknown_colour(const kdl::Value& value, std::string_view text, const Palette& palette,
                           Reading& reading)
{
    std::string hexadecimal{'#'};
    hexadecimal += text;
    if (text.starts_with('#'))
        reading.report.error(value.place, in_quotes(text) + " is no colour",
                             "write \"#rgb\", \"#rrggbb\" or, with opacity, \"#rgba\", \"#rrggbbaa\"");
    else if (text.size() >= 6 && hex_colour(hexadecimal))
        reading.report.error(value.place, in_quotes(text) + " is no colour",
                             "write " + in_quotes(hexadecimal) + ", with the quotes");
    else if (text == "none" || text == "transparent")
        reading.report.error(value.place, in_quotes(text) + " is no colour",
                             "leave the property out; a colour that is not seen is \"#0000\"");
    else
        reading.report.error(value.place, "unknown colour " + in_quotes(text), remedy_of(text, palette));
}

void report_unknown_word(const kdl::Value& value, std::string_view name,
                         std::span<const std::string_view> known, Reading& reading)
{
    reading.report.error(value.place, "unknown value " + in_quotes(name), word_remedy(name, known));
}

std::optional<Loop> read_loop(const kdl::Value& value, Reading& reading)
{
    return read_word(value, loops, reading);
}

void pass_on(const Diagnostic& finding, const kdl::Value& value, std::string_view what, Reading& reading)
{
    Place place = value.place;
    std::string message = finding.message;
    if (value.text_offset) {
        place = {*value.text_offset + finding.place.offset, finding.place.length};
    } else {
        const LineColumn at = line_column(*value.string(), finding.place.offset);
        message += " (line " + std::to_string(at.line) + ", column " + std::to_string(at.column) +
                   " of the " + std::string{what} + ")";
    }
    if (finding.severity == Severity::error)
        reading.report.error(place, message, finding.remedy);
    else
        reading.report.warning(place, message, finding.remedy);
}

}
