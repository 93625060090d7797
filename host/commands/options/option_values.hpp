#pragma once

#include "host/text/suggestion.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// A row for what has nothing but its name.
template <class T>
struct Named {
    std::string_view name;
    T value;
};

/// The names of rows that have one, for the help: "rgb565, mono1".
template <class Rows>
std::string names_of(const Rows& rows)
{
    std::string list;
    for (const auto& row : rows)
        list.append(list.empty() ? "" : ", ").append(row.name);
    return list;
}

/// The row of that name. Throws CLI::ValidationError in the name of `option` if there is none.
template <class Rows>
const auto& named(const Rows& rows, const std::string& option, const std::string& name)
{
    std::vector<std::string_view> known;
    for (const auto& row : rows) {
        if (row.name == name)
            return row;
        known.push_back(row.name);
    }
    throw CLI::ValidationError(option, "'" + name + "' is unknown: " + suggestion(name, known));
}

/// Keeps with the option which names it takes, for the completions of shells; it may take others as well.
CLI::Option* offer(CLI::Option* option, const std::vector<std::string_view>& names);

/// The same for the names of rows that have one.
template <class Rows>
CLI::Option* offer_names(CLI::Option* option, const Rows& rows)
{
    std::vector<std::string_view> names;
    names.reserve(std::size(rows));
    for (const auto& row : rows)
        names.push_back(row.name);
    return offer(option, names);
}

/// What was offered, or what a set allows that the option is checked by.
std::vector<std::string> offered_names(const CLI::Option& option);

/// A validator of CLI11 for numbers within bounds, which it describes as "0.1 to 3600". CLI::Range takes what
/// is no number at all ("nan") for one within them.
inline CLI::Validator number_within(double min, double max)
{
    const auto written = [](double bound) {
        char digits[32];
        return std::string{digits,
                           std::to_chars(digits, std::end(digits), bound, std::chars_format::fixed).ptr};
    };
    const std::string bounds = written(min) + " to " + written(max);
    const auto mistake = [=](const std::string& text) {
        double value = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc{} && rest == text.data() + text.size();
        return is_number && value >= min && value <= max ? ""
                                                         : "'" + text + "' is not a number from " + bounds;
    };
    return {mistake, bounds};
}

}
