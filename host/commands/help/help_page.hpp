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

std::string help_heading(const std::string& heading, const HelpStyle& style);
/// `text` in lines of at most `width` letters, of which all but the first are indented.
std::string broken_text(const std::string& text, std::size_t indent, std::size_t width);

/// What 'kfast COMMAND --help' prints.
std::string help_page(const CommandWords& command, const HelpStyle& style);
/// The same for standard output, of a command or of kfast itself.
std::string help_of(const CLI::App& app);

/// "kfast help render" as "kfast render --help", because the parser takes the name of a command for that
/// command, wherever it is. "kfast help laws", which is no command, stays as it is. `arguments` are those of
/// main().
std::vector<std::string> with_help_as_option(std::vector<std::string> arguments);

}
