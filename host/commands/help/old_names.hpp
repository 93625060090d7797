#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// How an option was written in the last version. It goes on working for one more, with a note, and neither
/// the help nor completions have it.
struct OldName {
    std::string_view command;
    std::string_view before;     ///< "--fit"
    std::string_view now;        ///< "--scaling"; empty: `before value` is what happens without it
    std::string_view value = {}; ///< the one that the flag `now` stands for, as --json for --format json
};

std::span<const OldName> old_names();

/// `arguments`, those of main(), with the options as they are called now. Of every old name among them a line
/// is written to `notes`. What follows "--" is no option.
std::vector<std::string> with_names_of_now(std::span<const char* const> arguments, std::ostream& notes);

}
