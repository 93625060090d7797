#pragma once

#include "host/text/suggestion.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// A row for what has only a name.
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

}
