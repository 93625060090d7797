#pragma once

#include "host/commands/help/command_words.hpp"

#include <string>
#include <vector>

namespace kfast {

/// What a terminal can show, or a file.
struct HelpStyle {
    bool has_colour = false; ///< headings are bold
    std::size_t width = 0;   ///< letters in a line, between which lines are broken; 0: lines stay whole
};

/// That of standard output. NO_COLOR takes the colour away.
HelpStyle style_of_standard_output();

/// What 'kfast COMMAND --help' prints.
std::string help_page(const CommandWords& command, const HelpStyle& style);
/// The same for standard output, of a command or of kfast itself.
std::string help_of(const CLI::App& app);

/// "kfast help render" as "kfast render --help", because the parser takes the name of a command for that
/// command, wherever it is. `arguments` are those of main().
std::vector<std::string> with_help_as_option(std::vector<std::string> arguments);

}
