#pragma once

#include <CLI/CLI.hpp>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

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

}
