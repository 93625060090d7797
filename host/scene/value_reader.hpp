#pragma once

#include "core/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/coordinate.hpp"
#include "host/scene/reading.hpp"
#include "host/text/suggestion.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Values of nodes and properties as what the language takes them for. Each function reports what is wrong
/// and then returns nothing.
namespace kfast::scene {

struct Range {
    double low;
    double high;
};

inline constexpr Range coordinates{-coordinate_limit, coordinate_limit};
/// Radii, widths and heights.
inline constexpr Range extents{0, 2 * coordinate_limit};

std::optional<double> read_number(const kdl::Value& value, Range range, Reading& reading);
std::optional<int> read_whole_number(const kdl::Value& value, Range range, Reading& reading);
/// Points into `value`.
std::optional<std::string_view> read_text(const kdl::Value& value, Reading& reading);

/// Frames, or (s) or (ms) by the scene's frame rate; rounded once to 1/1024 frame, halves away from zero.
std::optional<Time> read_time(const kdl::Value& value, Reading& reading);

/// The index among the colours in use.
std::optional<std::size_t> read_colour(const kdl::Value& value, Reading& reading);
void report_unknown_colour(const kdl::Value& value, std::string_view text,
                           std::span<const std::string_view> known, Reading& reading);

/// One of the words that a property takes.
template <class Meaning>
struct Word {
    std::string_view name;
    Meaning meaning;
};

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

/// Whether there was a value; then `target` has it.
template <class T, class U>
bool assign(const std::optional<T>& value, U& target)
{
    if (value)
        target = *value;
    return value.has_value();
}

}
