#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// How an option was written in the last version. It works for one more, with a note, and neither the help
/// nor completions have it.
struct OldName {
    std::string_view command;
    std::string_view before;     ///< "--fit"
    std::string_view now;        ///< "--scaling"; empty: `before value` is what happens without it
    std::string_view value = {}; ///< the one that the flag `now` replaces, as --json replaces --format json
};

std::span<const OldName> old_names();

/// `arguments`, those of main(), with the options as they are called now. Of every old name among them a line
/// is written to `notes`. What follows "--" is no option.
std::vector<std::string> with_names_of_now(std::span<const char* const> arguments, std::ostream& notes);

/// Throws Failure for a word that is no command, with the one that may be meant or all that there are.
/// Options are not checked. CLI11 alone would name neither the word nor the commands.
void require_command_among(std::span<const std::string_view> known, std::string_view word);

/// What is wrong with how `command` was called, in place of what CLI11 says of it: an option that it does not
/// have comes first, with the one that may be meant, for what else is missing may be due to it; then numbers
/// that are not whole, or out of range. `arguments` are those of main(); `error` is what their parsing threw.
std::string usage_mistake(const CLI::App& command, const CLI::Error& error,
                          std::span<const char* const> arguments);

}
