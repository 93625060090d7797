#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace kfast {

/// What is wrong with how `command` was called, in place of what CLI11 says of it: an option that it does not
/// have comes first, with the one that may be meant, for what else is missing may be due to it; then numbers
/// that are not whole, or out of range. `arguments` are those of main(); `error` is what their parsing threw.
std::string usage_mistake(const CLI::App& command, const CLI::Error& error,
                          std::span<const char* const> arguments);

}
