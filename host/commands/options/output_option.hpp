#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace kfast {

enum class StandardOutput { is_meant, is_refused }; ///< by "-"

/// -o, --output. A name that is empty, and "-" where it is refused, is a wrong use: both are mostly a slip in
/// a script, and a file called "-" is hard to get rid of.
CLI::Option* declare_output(CLI::App& app, std::string& output, const std::string& help,
                            StandardOutput by_dash = StandardOutput::is_refused);

}
