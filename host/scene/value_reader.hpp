#pragma once

#include "core/scene/kfb_limits.hpp"
#include "core/time/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/coordinate.hpp"
#include "host/scene/range.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/value_kind.hpp"
#include "host/text/suggestion.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Values of nodes and properties as what the language takes them for. Each function reports what is wrong
/// and then returns nothing.
namespace kfast::scene {

inline constexpr Range coordinates{-coordinate_limit, coordinate_limit};
/// Radii, widths and heights.
inline constexpr Range extents{0, 2 * coordinate_limit};
/// Degrees: ten turns either way.
inline constexpr Range angles{-3600, 3600};

/// Of an input, in whole numbers.
inline constexpr std::int32_t input_limit = kfb::max_input_value / 1000;
inline constexpr Range input_values{-input_limit, input_limit};
/// As values of inputs are stored: rounded to nearest, halves away from zero.
std::int32_t thousandths(double number);

/// As few digits as tell the number: "0.0625"
std::string text_of(double number);

/// Only as many decimals as it takes: `is_same` tells whether a rounded number still stands for `number`,
/// which it must at some point.
template <class IsSame>
std::string shortest_text(double number, IsSame is_same)
{
    for (double parts = 1;; parts *= 10) {
        const double rounded = std::round(number * parts) / parts;
        if (is_same(rounded))
            return text_of(rounded);
    }
}

/// The remedy for a number that is not inside: "allowed: 0 to 1".
std::string allowed(Range range);

std::optional<double> read_number(const kdl::Value& value, Range range, Reading& reading);
void report_out_of_range(const kdl::Value& value, Range range, Reading& reading);
/// The last of `ranges`, of which there is at least one, holds for all that follow.
std::optional<std::vector<double>> read_numbers(std::span<const kdl::Value> values,
                                                std::span<const Range> ranges, Reading& reading);
std::optional<int> read_whole_number(const kdl::Value& value, Range range, Reading& reading);
/// #true or #false.
std::optional<bool> read_flag(const kdl::Value& value, Reading& reading);
/// Points into `value`.
std::optional<std::string_view> read_text(const kdl::Value& value, Reading& reading);
/// What something is called: 1 to longest_name bytes.
std::optional<std::string_view> read_name(const kdl::Value& value, Reading& reading);

/// Frames, or (s) or (ms) by the scene's frame rate; rounded once to 1/1024 frame, halves away from zero.
std::optional<Time> read_time(const kdl::Value& value, Reading& reading);
/// In frames, exactly: "60", "7.5"
std::string text_of(Time time);

/// The index among the colours in use.
std::optional<std::size_t> read_colour(const kdl::Value& value, Reading& reading);
/// `palette` has the colours that there are.
void report_unknown_colour(const kdl::Value& value, std::string_view text, const Palette& palette,
                           Reading& reading);

void report_unknown_word(const kdl::Value& value, std::string_view name,
                         std::span<const std::string_view> known, Reading& reading);

template <class Meaning, std::size_t count>
std::optional<Meaning> read_word(const kdl::Value& value, const std::array<Word<Meaning>, count>& words,
                                 Reading& reading)
{
    const auto name = read_text(value, reading);
    if (!name)
        return std::nullopt;
    std::array<std::string_view, count> known;
    for (std::size_t i = 0; i < count; ++i) {
        if (words[i].name == *name)
            return words[i].meaning;
        known[i] = words[i].name;
    }
    report_unknown_word(value, *name, known, reading);
    return std::nullopt;
}

inline constexpr std::array loops{
    Word<Loop>{"once", Loop::once},
    Word<Loop>{"repeat", Loop::repeat},
    Word<Loop>{"ping-pong", Loop::ping_pong},
};
std::optional<Loop> read_loop(const kdl::Value& value, Reading& reading);

/// Where a part of the text of `value` stands in the source; where that is not known, the whole value.
inline Place place_in_text(const kdl::Value& value, Place part)
{
    return value.text_offset ? Place{*value.text_offset + part.offset, part.length} : value.place;
}

/// Passes on a finding inside the text of `value` at its place in the source; where that is not known (the
/// text has escapes or several lines), at the whole value with the place in words, in the text that `what`
/// names.
void pass_on(const Diagnostic& finding, const kdl::Value& value, std::string_view what, Reading& reading);

/// Whether there was a value; then `target`, whose type holds it, has it.
template <class T, class U>
bool assign(const std::optional<T>& value, U& target)
{
    if (value)
        target = static_cast<U>(*value);
    return value.has_value();
}

}
