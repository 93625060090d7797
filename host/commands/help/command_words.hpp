#pragma once

#include "host/commands/options/option_facts.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace kfast {

/// An option or a positional argument, for completions and man pages.
struct OptionWords {
    std::vector<std::string> names; ///< "-o", "--output"; of a positional one, its name alone
    bool is_positional = false;
    bool takes_value = false;
    bool is_required = false;
    bool takes_many = false;  ///< one after the other
    std::string type;         ///< how the help writes the value: "WxH"
    std::string default_text; ///< unless the help has it
    std::string help;
    std::string group;
    OptionFacts facts; ///< what is known of it
};

/// The help with all that is known of the value: its range, its default, and the words it may be.
std::string whole_help(const OptionWords& option);

/// A command as the parser of the command line has it, and the commands inside of it.
struct CommandWords {
    std::string name; ///< "uf2 pack"; the whole program has none
    std::string summary;
    std::string group;
    std::string footer;               ///< after the help: examples
    std::vector<OptionWords> options; ///< positional ones first, others by their groups (option_groups.hpp)
    std::vector<CommandWords> subcommands;
};

CommandWords words_of_command(const CLI::App& app, const std::string& name = "");

}
