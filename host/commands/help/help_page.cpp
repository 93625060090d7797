#include "host/commands/help/help_page.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace kfast {
namespace {

constexpr std::size_t widest_term = 26; ///< the text of a wider one begins in the next line
constexpr std::size_t narrowest_text = 24;
constexpr std::size_t widest_page = 100;

/// Options or commands with what they do, under a heading.
struct HelpList {
    std::string heading;
    std::vector<std::pair<std::string, std::string>> rows;
};

std::string term_text(const OptionWords& option)
{
    std::string term;
    for (const std::string& name : option.names)
        term.append(term.empty() ? "" : ", ").append(name);
    if (!option.is_positional && option.takes_value)
        term += ' ' + option.type;
    return option.takes_many && option.is_positional ? term + " ..." : term;
}

std::string row_of(const std::pair<std::string, std::string>& row, std::size_t column, const HelpStyle& style)
{
    const auto& [term, text] = row;
    std::string line = "  " + term;
    if (text.empty())
        return line + '\n';
    line +=
        line.size() + 2 > column ? '\n' + std::string(column, ' ') : std::string(column - line.size(), ' ');
    const bool is_broken = style.width >= column + narrowest_text;
    return line + (is_broken ? broken_text(text, column, style.width - column) : text) + '\n';
}

std::size_t text_column(const std::vector<HelpList>& lists)
{
    std::size_t widest = 0;
    for (const HelpList& list : lists)
        for (const auto& row : list.rows)
            widest = std::max(widest, row.first.size() <= widest_term ? row.first.size() : 0);
    return widest + 4;
}

HelpList& list_called(const std::string& heading, std::vector<HelpList>& lists)
{
    const auto found = std::ranges::find(lists, heading, &HelpList::heading);
    return found != lists.end() ? *found : lists.emplace_back(HelpList{heading, {}});
}

std::vector<HelpList> lists_of(const CommandWords& command)
{
    std::vector<HelpList> lists;
    for (const OptionWords& option : command.options)
        if (option.is_positional)
            list_called("Arguments", lists).rows.emplace_back(term_text(option), whole_help(option));
    for (const CommandWords& inner : command.subcommands)
        list_called(inner.group, lists)
            .rows.emplace_back(inner.name.substr(inner.name.rfind(' ') + 1), inner.summary);
    for (const OptionWords& option : command.options)
        if (!option.is_positional)
            list_called(option.group, lists).rows.emplace_back(term_text(option), whole_help(option));
    return lists;
}

std::string usage_text(const CommandWords& command)
{
    std::string text = "Usage: kfast" + (command.name.empty() ? "" : ' ' + command.name) + " [OPTIONS]";
    if (!command.subcommands.empty())
        text += " COMMAND";
    for (const OptionWords& option : command.options)
        if (option.is_positional)
            text += option.is_required ? ' ' + term_text(option) : " [" + term_text(option) + ']';
    return text + '\n';
}

/// With what begins a part of it, "Example:", as a heading.
std::string footer_text(const std::string& footer, const HelpStyle& style)
{
    std::istringstream lines{footer};
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        const bool is_heading = line.ends_with(':') && !line.starts_with(' ');
        text += is_heading ? help_heading(line.substr(0, line.size() - 1), style) : line + '\n';
    }
    return text;
}

}

HelpStyle style_of_standard_output()
{
    if (::isatty(STDOUT_FILENO) == 0)
        return {};
    const char* const no_colour = std::getenv("NO_COLOR");
    winsize window{};
    const bool has_width = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0;
    return {.has_colour = no_colour == nullptr || *no_colour == '\0',
            .width = has_width ? std::min<std::size_t>(window.ws_col, widest_page) : 0};
}

std::string help_heading(const std::string& heading, const HelpStyle& style)
{
    return style.has_colour ? "\x1b[1;36m" + heading + ":\x1b[0m\n" : heading + ":\n";
}

std::string broken_text(const std::string& text, std::size_t indent, std::size_t width)
{
    std::istringstream words{text};
    std::string lines;
    std::size_t length = 0;
    for (std::string word; words >> word; length += word.size()) {
        if (length > 0 && length + 1 + word.size() > width) {
            lines += '\n' + std::string(indent, ' ');
            length = 0;
        } else if (length > 0) {
            lines += ' ';
            ++length;
        }
        lines += word;
    }
    return lines;
}

std::string help_page(const CommandWords& command, const HelpStyle& style)
{
    std::string text = command.summary + '\n' + usage_text(command);
    const std::vector<HelpList> lists = lists_of(command);
    const std::size_t column = text_column(lists);
    for (const HelpList& list : lists) {
        text += '\n' + help_heading(list.heading, style);
        for (const auto& row : list.rows)
            text += row_of(row, column, style);
    }
    return command.footer.empty() ? text : text + '\n' + footer_text(command.footer, style);
}

std::string help_of(const CLI::App& app)
{
    std::string name;
    for (const CLI::App* command = &app; command->get_parent() != nullptr; command = command->get_parent())
        name = command->get_name() + (name.empty() ? "" : ' ' + name);
    return help_page(words_of_command(app, name), style_of_standard_output());
}

std::vector<std::string> with_help_as_option(std::vector<std::string> arguments)
{
    const bool is_help = arguments.size() > 1 && arguments[1] == "help";
    if (!is_help || (arguments.size() > 2 && (arguments[2].starts_with('-') || arguments[2] == "laws")))
        return arguments;
    arguments.erase(arguments.begin() + 1);
    arguments.emplace_back("--help");
    return arguments;
}

}
