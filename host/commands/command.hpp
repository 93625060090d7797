#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string_view>

namespace kfast {

/// One subcommand of kfast.
struct Command {
    const char* name;
    const char* summary;
    const char* example; ///< for the end of its help
    /// Declares the arguments and, as CLI11's callback, what is done with them. The callback throws Failure
    /// for a wrong input or file and CLI::ParseError for a wrong use.
    void (*declare)(CLI::App& app);
    std::span<const std::string_view> subcommands = {}; ///< if there are any, one of them follows
};

extern const Command new_command;
extern const Command compile_command;
extern const Command check_command;
extern const Command info_command;
extern const Command render_command;
extern const Command preview_command;
extern const Command hash_command;
extern const Command export_command;
extern const Command fit_command;
extern const Command config_command;
extern const Command wiring_command;
extern const Command uf2_command;

/// The whole program. Returns its exit status: 0, 1 (the input is wrong, or a file cannot be read or
/// written) or 2 (the usage is wrong).
int run_command_line(int count, const char* const* arguments);

}
