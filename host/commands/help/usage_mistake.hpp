#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// Throws Failure for a word that is no command, with the one that may be meant or all that there are.
/// Options are not looked at. CLI11 alone would name neither the word nor the commands.
void require_command_among(std::span<const std::string_view> known, std::string_view word);

/// What is wrong with how `command` was called, in place of what CLI11 says of it: an option that it does not
/// have comes first, with the one that may be meant, for what else is missing may be due to it; then numbers
/// that are not whole, or out of range. `arguments` are those of main(); `error` is what their parsing threw.
std::string usage_mistake(const CLI::App& command, const CLI::Error& error,
                          std::span<const char* const> arguments);

}
