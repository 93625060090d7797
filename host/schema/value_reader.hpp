#pragma once

#include "host/kdl/document.hpp"
#include "host/schema/expression.hpp"
#include "host/schema/report.hpp"
#include "host/schema/value_kind.hpp"
#include "host/text/suggestion.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Reads values of nodes and properties as the types of the language. Each function reports what is wrong and
/// then returns nothing.
namespace kfast::schema {

/// The fewest digits that identify the number: "0.0625"
std::string text_of(double number);

/// Only as many decimals as it takes: `is_same` returns whether a rounded number still represents `number`,
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

/// The hint for a number that is not inside: "allowed: 0 to 1".
std::string allowed(Range range);

/// Whether the number may be an expression here, and the value is one. A mere word is none in a text without
/// variables, which does not need to be told of them.
bool is_expression(const kdl::Value& value, const Report& report);
/// What `found` in the text of `value`; reports what is wrong.
std::optional<double> result_of(const Evaluation& found, const kdl::Value& value, Report& report);
/// A number or what an expression comes to, with a unit or without one; reports if it is none. All numbers of
/// a text are read by it.
std::optional<double> number_of(const kdl::Value& value, Report& report);
std::optional<double> read_number(const kdl::Value& value, Range range, Report& report);
void report_out_of_range(const kdl::Value& value, Range range, Report& report);
/// The last of `ranges`, of which there is at least one, applies to all that follow.
std::optional<std::vector<double>> read_numbers(std::span<const kdl::Value> values,
                                                std::span<const Range> ranges, Report& report);
std::optional<int> read_whole_number(const kdl::Value& value, Range range, Report& report);
/// Reads #true or #false.
std::optional<bool> read_flag(const kdl::Value& value, Report& report);
/// Points into `value`.
std::optional<std::string_view> read_text(const kdl::Value& value, Report& report);
inline constexpr std::size_t max_name_bytes = 255;
/// Reads a name: 1 to max_name_bytes bytes.
std::optional<std::string_view> read_name(const kdl::Value& value, Report& report);

void report_unknown_word(const kdl::Value& value, std::string_view name,
                         std::span<const std::string_view> known, Report& report);

template <class Meaning, std::size_t count>
std::optional<Meaning> read_word(const kdl::Value& value, const std::array<Word<Meaning>, count>& words,
                                 Report& report)
{
    const auto name = read_text(value, report);
    if (!name)
        return std::nullopt;
    std::array<std::string_view, count> known;
    for (std::size_t i = 0; i < count; ++i) {
        if (words[i].name == *name)
            return words[i].meaning;
        known[i] = words[i].name;
    }
    report_unknown_word(value, *name, known, report);
    return std::nullopt;
}

/// The location in the source of a part of the text of `value`; if that is not known, of the whole value.
inline SourceSpan place_in_text(const kdl::Value& value, SourceSpan part)
{
    return value.text_offset ? SourceSpan{*value.text_offset + part.offset, part.length} : value.place;
}

/// Passes on a finding inside the text of `value` at its location in the source; if that is not known (the
/// text has escapes or several lines), at the whole value with the location in words, in the text that `what`
/// names.
void pass_on(const Diagnostic& finding, const kdl::Value& value, std::string_view what, Report& report);

/// Stores the value in `target`, whose type holds it; returns whether there was one.
template <class T, class U>
bool assign(const std::optional<T>& value, U& target)
{
    if (value)
        target = static_cast<U>(*value);
    return value.has_value();
}

/// A unit that numbers of a kind are written with, as in (MHz)125.
struct QuantityUnit {
    std::string_view name;
    double factor;
};

/// The kind of quantity that a number with a unit is.
struct QuantityForm {
    std::string_view noun;               ///< "a frequency"
    std::string_view example;            ///< "(MHz)125"
    std::span<const QuantityUnit> units; ///< the likeliest first
};

inline constexpr std::array frequency_units{QuantityUnit{"Hz", 1}, QuantityUnit{"kHz", 1e3},
                                            QuantityUnit{"MHz", 1e6}};
inline constexpr std::array memory_units{QuantityUnit{"KiB", 1024}, QuantityUnit{"MiB", 1024 * 1024},
                                         QuantityUnit{"B", 1}};
inline constexpr std::array duration_units{QuantityUnit{"s", 1}, QuantityUnit{"ms", 1e-3}};
inline constexpr QuantityForm frequency{"a frequency", "(MHz)125", frequency_units};
inline constexpr QuantityForm memory_size{"a size of memory", "(KiB)264", memory_units};
inline constexpr QuantityForm duration{"a duration", "(s)8.3", duration_units};

/// The fewest digits that identify it, in the largest unit of which it has at least one: "(MHz)62.5"
std::string quantity_text(double quantity, const QuantityForm& form);

/// Returns Hz, bytes or seconds. Reports what is wrong and then returns nothing.
std::optional<double> read_quantity(const kdl::Value& value, const QuantityForm& form, Range range,
                                    Report& report);

}
